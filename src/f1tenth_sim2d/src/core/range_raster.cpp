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
// Turns. More than half a turn between the ends of a wall is rounding of a wall seen edge-on.
constexpr double kWidthMax = 0.5 + 1e-6;
constexpr double kRoughAngleError = 1e-7;  // rad

/// atan2 to within kRoughAngleError at a fifth of the price: Abramowitz and Stegun, 4.4.49, error below 2e-8.
double roughAngle(const Vec2 & point)
{
  const double x = std::abs(point.x);
  const double y = std::abs(point.y);
  const double t = std::min(x, y) / std::max(x, y);
  const double u = t * t;
  double series = 0.0028662257;
  for (const double coefficient :
       {-0.0161657367, 0.0429096138, -0.0752896400, 0.1065626393, -0.1420889944, 0.1999355085, -0.3333314528, 1.0}) {
    series = series * u + coefficient;
  }
  const double octant = t * series;
  const double quadrant = y > x ? 0.5 * kPi - octant : octant;
  return std::copysign(point.x < 0.0 ? kPi - quadrant : quadrant, point.y);
}
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

// Within [0, beams_per_turn).
double RangeRaster::beamOf(double angle) const
{
  const double beam = (angle - beams_.angle_min) * beams_.beams_per_radian;
  return beam < 0.0 ? beam + beams_.beams_per_turn : beam;
}

double RangeRaster::beamOf(const Vec2 & point)
{
  if (point.x != last_point_.x || point.y != last_point_.y) {
    last_point_ = point;
    last_beam_ = beamOf(roughAngle(point));
    // What matters is only between which beams the point lies.
    const double to_beam = last_beam_ - static_cast<int>(last_beam_ + 0.5);
    if (std::abs(to_beam) < kRoughAngleError * beams_.beams_per_radian + kCornerTolerance) {
      last_beam_ = beamOf(std::atan2(point.y, point.x));
    }
  }
  return last_beam_;
}

// Calls draw(first, last) for the beams within [begin, begin + width]: more than once if the interval leaves the field
// of view on one side and comes back on the other.
template <typename Draw>
void RangeRaster::forEachInterval(double begin, double width, Draw draw) const
{
  const double last_beam = beams_.count() - 1;
  for (begin -= beams_.beams_per_turn; begin <= last_beam + kCornerTolerance; begin += beams_.beams_per_turn) {
    const double from = std::max(begin - kCornerTolerance, 0.0);
    const double to = std::min(begin + width + kCornerTolerance, last_beam);
    const int whole = static_cast<int>(from);
    const int first = whole < from ? whole + 1 : whole;
    if (first <= to) {
      draw(first, static_cast<int>(to));
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
  const double beam_a = beamOf(a);
  const double beam_b = beamOf(b);
  const double width = beam_a < beam_b ? beam_a - beam_b + beams_.beams_per_turn : beam_a - beam_b;
  if (width > kWidthMax * beams_.beams_per_turn) {
    return;
  }
  const double along_cosine = (b.y - a.y) / cross;
  const double along_sine = (a.x - b.x) / cross;
  forEachInterval(beam_b, width, [&](int first, int last) {
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
  const double left_to_right = 2.0 * half_width * beams_.beams_per_radian;
  forEachInterval(
    beamOf(wrapAngle(std::atan2(centre.y, centre.x) - half_width)), left_to_right, [&](int first, int last) {
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
  for (std::size_t i = 0; i < inverse_ranges_.size(); ++i) {
    ranges[i] = 1.0 / inverse_ranges_[i];
  }
}
}  // namespace f1tenth_sim2d
