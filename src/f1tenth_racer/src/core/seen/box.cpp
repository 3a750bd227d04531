#include "seen/box.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
double Box::distanceTo(const Vec2 & point) const
{
  const Vec2 away = point - middle.position();
  const double c = maths::cos(middle.yaw);
  const double s = maths::sin(middle.yaw);
  const double along = std::abs(c * away.x + s * away.y) - half_length;
  const double across = std::abs(c * away.y - s * away.x) - half_width;
  const double outside = maths::hypot(std::max(along, 0.0), std::max(across, 0.0));
  return outside > 0.0 ? outside : std::max(along, across);
}

Box grown(const Box & box, double margin)
{
  return {box.middle, box.half_length + margin, box.half_width + margin};
}

double clearance(const Box & box, const Footprint & footprint, const Pose2 & base)
{
  double least = HUGE_VAL;
  for (const Disc & disc : footprint.discs()) {
    least = std::min(least, box.distanceTo(transform(base, disc.centre)) - disc.radius);
  }
  return least;
}
}  // namespace f1tenth_racer
