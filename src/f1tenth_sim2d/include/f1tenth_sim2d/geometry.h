#pragma once

#include <vector>

namespace f1tenth_sim2d
{
/// A point or vector in the plane, m (or m/s), REP-103 axes.
struct Vec2
{
  double x{0.0};
  double y{0.0};
};

/// A pose in the plane: position in m, yaw in rad, counter-clockwise.
struct Pose2
{
  double x{0.0};
  double y{0.0};
  double yaw{0.0};
};

/// A convex polygon, counter-clockwise, at least three corners, without its closing corner; m.
using ConvexPolygon = std::vector<Vec2>;

/// A closed outline of any shape, counter-clockwise around solid matter, without its closing corner; m.
using Outline = std::vector<Vec2>;
}  // namespace f1tenth_sim2d
