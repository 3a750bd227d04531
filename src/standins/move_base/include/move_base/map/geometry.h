#pragma once

#include <workspace_support/grid.h>
#include <workspace_support/planar.h>

namespace move_base
{
using namespace workspace_support;

/// From low to high, m.
struct Interval
{
  double low{0.0};
  double high{0.0};
};

/// Where a car is after driving an arc.
/// @param length     m along the arc, negative backwards
/// @param curvature  1/m, of the wheels' setting: positive is steering to the left
Pose2 advance(const Pose2 & pose, double length, double curvature);

/// The direction to the left of a pose.
Vec2 leftNormal(const Pose2 & pose);

/// Between two poses.
/// @param part  0: at a, 1: at b
Pose2 between(const Pose2 & a, const Pose2 & b, double part);

/// Fraction of the straight line from a to b, within [0, 1], at which it is nearest to a point; 0 where a is b.
double nearestPart(const Vec2 & a, const Vec2 & b, const Vec2 & point);
/// From a point to the straight line from a to b, m.
double distanceToLine(const Vec2 & a, const Vec2 & b, const Vec2 & point);
}  // namespace move_base
