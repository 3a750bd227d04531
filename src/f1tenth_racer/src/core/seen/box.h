#pragma once

#include <move_base/map/footprint.h>
#include <move_base/map/geometry.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// A rectangle in the plane.
struct Box
{
  Pose2 middle;             ///< heading: that of the length
  double half_length{0.0};  ///< m
  double half_width{0.0};   ///< m

  /// Distance from a point, m; 0 or less inside.
  double distanceTo(const Vec2 & point) const;
};

/// The same with every side moved outwards by margin, m.
Box grown(const Box & box, double margin);

/// Least distance from the outline of a car at base to the box, m, underestimated by what the discs stick out;
/// negative on contact.
double clearance(const Box & box, const Footprint & footprint, const Pose2 & base);
}  // namespace f1tenth_racer
