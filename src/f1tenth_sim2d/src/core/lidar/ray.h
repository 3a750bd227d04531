#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/section.h"

namespace f1tenth_sim2d
{
/// A ray and how far it reaches so far. It meets what the beams of a lidar meet: walls from their right side, circles from
/// outside.
struct Ray
{
  /// In lengths of a wall: a ray through a corner meets both walls there, whatever the rounding.
  static constexpr double kAtCorner = 1e-9;

  Vec2 origin;     ///< m
  Vec2 direction;  ///< of length 1
  double range;    ///< m, nothing farther away counts

  Vec2 at(double distance) const { return {origin.x + distance * direction.x, origin.y + distance * direction.y}; }

  /// The same ray seen from a body.
  Ray seenFrom(const Transform2 & body) const { return {body.applyBack(origin), body.rotateBack(direction), range}; }

  /// Ends at the wall from a to b if it meets it.
  void meetWall(const Vec2 & a, const Vec2 & b)
  {
    const Vec2 to_a{a.x - origin.x, a.y - origin.y};
    const Vec2 edge{b.x - a.x, b.y - a.y};
    const double facing = to_a.x * edge.y - to_a.y * edge.x;
    const double slope = direction.x * edge.y - direction.y * edge.x;
    if (facing >= 0.0 || slope >= 0.0) {
      return;
    }
    const double along = (to_a.x * direction.y - to_a.y * direction.x) / slope;
    if (along >= -kAtCorner && along <= 1.0 + kAtCorner) {
      range = std::min(range, facing / slope);
    }
  }

  /// Likewise at a full circle.
  void meetCircle(const Circle & circle)
  {
    const Vec2 to_centre{circle.centre.x - origin.x, circle.centre.y - origin.y};
    const double along = to_centre.x * direction.x + to_centre.y * direction.y;
    const double aside = to_centre.x * direction.y - to_centre.y * direction.x;
    const double outside = to_centre.x * to_centre.x + to_centre.y * to_centre.y - circle.radius * circle.radius;
    const double squared = circle.radius * circle.radius - aside * aside;
    if (outside > 0.0 && along > 0.0 && squared >= 0.0) {
      range = std::min(range, along - std::sqrt(squared));
    }
  }
};
}  // namespace f1tenth_sim2d
