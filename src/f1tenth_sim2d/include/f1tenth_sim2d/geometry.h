#pragma once

#include <workspace_support/planar.h>

#include <vector>

namespace f1tenth_sim2d
{
using workspace_support::Pose2;
using workspace_support::Vec2;

/// A convex polygon, counter-clockwise, at least three corners, without its closing corner; m.
using ConvexPolygon = std::vector<Vec2>;

/// A closed outline of any shape, counter-clockwise around solid matter, without its closing corner; m.
using Outline = std::vector<Vec2>;
}  // namespace f1tenth_sim2d
