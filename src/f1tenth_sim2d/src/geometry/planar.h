#pragma once

#include <vector>

#include "f1tenth_sim2d/geometry.h"

/// Plane geometry that sections, footprints and decomposition share.
namespace f1tenth_sim2d
{
/// Lengths below it are rounding errors, m.
constexpr double kTolerance = 1e-9;

/// Twice the signed area of the triangle a, b, c: positive when they turn left, m^2.
double turn(const Vec2 & a, const Vec2 & b, const Vec2 & c);

/// Signed area of an outline, positive when counter-clockwise, m^2.
double signedArea(const Outline & outline);

/// The outline counter-clockwise and without corners that lie on the line through their neighbours.
/// Empty if nothing with an area is left.
Outline withoutRedundantCorners(Outline outline);

/// Whether an outline encloses an area and does not cross or touch itself.
bool isSimple(const Outline & outline);

/// Whether the edges of two outlines cross or touch.
bool edgesMeet(const Outline & a, const Outline & b);

/// Whether a point is within an outline, not on it.
bool contains(const Outline & outline, const Vec2 & point);

/// Convex hull of points; empty if they lie on a line.
ConvexPolygon convexHull(const std::vector<Vec2> & points);
}  // namespace f1tenth_sim2d
