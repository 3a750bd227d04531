#include "moments.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

namespace gmapping
{
namespace
{
// Two points always form a line, but a wrong one more often than not.
constexpr int kLeastPoints = 3;
constexpr double kLeastVariance = 1e-4;  // m^2 along the line
constexpr double kGreatestWidth = 0.25;  // variance across the line over that along it
}  // namespace

void Moments::add(const Vec2 & point, double weight)
{
  ++count_;
  weight_ += weight;
  x_ += weight * point.x;
  y_ += weight * point.y;
  xx_ += weight * point.x * point.x;
  xy_ += weight * point.x * point.y;
  yy_ += weight * point.y * point.y;
}

std::optional<Vec2> Moments::normal() const
{
  if (count_ < kLeastPoints) {
    return std::nullopt;
  }
  const Vec2 centre = mean();
  const double xx = xx_ / weight_ - centre.x * centre.x;
  const double xy = xy_ / weight_ - centre.x * centre.y;
  const double yy = yy_ / weight_ - centre.y * centre.y;
  const double middle = 0.5 * (xx + yy);
  const double half_range = maths::hypot(0.5 * (xx - yy), xy);
  const double along = middle + half_range;
  const double across = middle - half_range;
  if (along < kLeastVariance || across > kGreatestWidth * along) {
    return std::nullopt;
  }
  const double angle = 0.5 * maths::atan2(2.0 * xy, xx - yy);
  return Vec2{-maths::sin(angle), maths::cos(angle)};
}
}  // namespace gmapping
