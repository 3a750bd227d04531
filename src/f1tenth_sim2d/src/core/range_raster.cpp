#include "range_raster.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
// In beams. A beam through a corner hits both walls that meet there, whatever the rounding: otherwise it could
// slip through between them.
constexpr double kCornerTolerance = 1e-9;
// rad. More than half a turn between the ends of a wall is rounding of a wall seen edge-on.
constexpr double kSpanMax = kPi + 1e-6;
}  // namespace

RangeRaster::RangeRaster(const LidarDescription & lidar)
: beams_(lidar), range_max_(lidar.range_max), inverse_ranges_(beams_.count())
{
}

void RangeRaster::begin(const Pose2 & sensor)
{
  sensor_ = Transform2(sensor);
  std::fill(inverse_ranges_.begin(), inverse_ranges_.end(), 0.0);
  last_point_.x = std::numeric_limits<double>::quiet_NaN();
}

double RangeRaster::angleOf(const Vec2 & point)
{
  if (point.x != last_point_.x || point.y != last_point_.y) {
    last_point_ = point;
    last_angle_ = std::atan2(point.y, point.x);
  }
  return last_angle_;
}

// Calls draw(first, last) for the beams within [angle_begin, angle_begin + span], once a turn if the field of view
// has both ends of the interval on its two sides.
template <typename Draw>
void RangeRaster::forEachInterval(double angle_begin, double span, Draw draw) const
{
  const int last_beam = beams_.count() - 1;
  const double turn = beams_.beams_per_turn;
  double begin = (angle_begin - beams_.angle_min) * beams_.beams_per_radian;
  begin -= std::floor(begin / turn) * turn;
  const double width = span * beams_.beams_per_radian;
  for (begin -= turn; begin <= last_beam + kCornerTolerance; begin += turn) {
    const int first = static_cast<int>(std::ceil(std::max(begin - kCornerTolerance, 0.0)));
    const double end = std::min(begin + width + kCornerTolerance, static_cast<double>(last_beam));
    if (end >= 0.0 && first <= end) {
      draw(first, static_cast<int>(end));
    }
  }
}

void RangeRaster::addSegment(const Vec2 & a_world, const Vec2 & b_world)
{
  const Vec2 to_a{a_world.x - sensor_.x, a_world.y - sensor_.y};
  const Vec2 to_b{b_world.x - sensor_.x, b_world.y - sensor_.y};
  const Vec2 edge_world{b_world.x - a_world.x, b_world.y - a_world.y};
  const double cross = to_a.x * edge_world.y - to_a.y * edge_world.x;
  const double length_squared = edge_world.x * edge_world.x + edge_world.y * edge_world.y;
  if (!(cross < 0.0) || cross * cross > range_max_ * range_max_ * length_squared) {
    return;
  }
  const Vec2 a = sensor_.rotateBack(to_a);
  const Vec2 b = sensor_.rotateBack(to_b);
  const double angle_a = angleOf(a);
  const double angle_b = angleOf(b);
  const double difference = angle_a - angle_b;
  const double span = difference < 0.0 ? difference + 2.0 * kPi : difference;
  if (span > kSpanMax) {
    return;
  }
  const double along_cosine = (b.y - a.y) / cross;
  const double along_sine = (a.x - b.x) / cross;
  forEachInterval(angle_b, span, [&](int first, int last) {
    const double * cosine = beams_.cosine.data();
    const double * sine = beams_.sine.data();
    double * inverse = inverse_ranges_.data();
    for (int i = first; i <= last; ++i) {
      const double value = along_cosine * cosine[i] + along_sine * sine[i];
      inverse[i] = value > inverse[i] ? value : inverse[i];
    }
  });
}

void RangeRaster::addCircle(const Vec2 & centre_world, double radius)
{
  const Vec2 centre = sensor_.applyBack(centre_world);
  const double distance = std::hypot(centre.x, centre.y);
  if (distance <= radius || distance - radius > range_max_) {
    return;
  }
  const double half_width = std::asin(radius / distance);
  const double radius_squared = radius * radius;
  forEachInterval(std::atan2(centre.y, centre.x) - half_width, 2.0 * half_width, [&](int first, int last) {
    const double * cosine = beams_.cosine.data();
    const double * sine = beams_.sine.data();
    double * inverse = inverse_ranges_.data();
    for (int i = first; i <= last; ++i) {
      const double along = centre.x * cosine[i] + centre.y * sine[i];
      const double aside = centre.y * cosine[i] - centre.x * sine[i];
      const double value = 1.0 / (along - std::sqrt(std::max(radius_squared - aside * aside, 0.0)));
      inverse[i] = value > inverse[i] ? value : inverse[i];
    }
  });
}

void RangeRaster::finish(double * ranges) const
{
  const double inverse_max = 1.0 / range_max_;
  for (std::size_t i = 0; i < inverse_ranges_.size(); ++i) {
    const double inverse = inverse_ranges_[i];
    ranges[i] = inverse >= inverse_max ? 1.0 / inverse : std::numeric_limits<double>::infinity();
  }
}
}  // namespace f1tenth_sim2d
