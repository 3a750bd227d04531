#include "core/lidar/range_raster.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
constexpr int kFewBeams = 6;  // not worth a call
// Tolerance of a bound, so that rounding never hides anything.
constexpr double kSlack = 1e-6;
}  // namespace

RangeRaster::RangeRaster(const Beams & beams) : inverse_ranges_(beams.count)
{
  view_.angle_min = normalizeAngle(beams.angle_min);
  view_.beams_per_radian = beams.perRadian();
  view_.beams_per_turn = 2.0 * M_PI * view_.beams_per_radian;
  view_.last_beam = beams.count - 1;
  cosine_.reserve(beams.count);
  sine_.reserve(beams.count);
  for (int i = 0; i < beams.count; ++i) {
    const maths::SineCosine at = maths::sineCosine(view_.angle_min + i / view_.beams_per_radian);
    cosine_.push_back(at.cosine);
    sine_.push_back(at.sine);
  }
}

void RangeRaster::begin(const Pose2 & sensor, double range_max)
{
  view_.sensor = Transform2(sensor);
  view_.range_max = range_max;
  std::fill(inverse_ranges_.begin(), inverse_ranges_.end(), 0.0);
  unseeing_ = 0;
}

// Whether visit(first, last) is true for beams within [begin, begin + width]; asked more than once if the interval
// leaves the field of view on one side and comes back on the other.
template <typename Visit>
bool RangeRaster::anyInterval(double begin, double width, Visit visit) const
{
  begin -= view_.beams_per_turn;
  if (begin + width + kCornerTolerance < 0.0) {
    begin += view_.beams_per_turn;
  }
  for (; begin <= view_.last_beam + kCornerTolerance; begin += view_.beams_per_turn) {
    const double from = std::max(begin - kCornerTolerance, 0.0);
    const double to = std::min(begin + width + kCornerTolerance, view_.last_beam);
    const int whole = static_cast<int>(from);
    const int first = whole < from ? whole + 1 : whole;
    if (first <= to && visit(first, static_cast<int>(to))) {
      return true;
    }
  }
  return false;
}

// For angles from half a turn below to half a turn above: within one turn about [0, beams_per_turn).
double RangeRaster::beamOf(double angle) const
{
  const double beam = (angle - view_.angle_min) * view_.beams_per_radian;
  return beam < 0.0 ? beam + view_.beams_per_turn : beam;
}

void RangeRaster::drawSeen(const WallEnds & walls, std::size_t wall)
{
  if (seen_.kind[wall] == SeenWalls::kPlain) {
    draw(wall, static_cast<int>(seen_.first[wall]), static_cast<int>(seen_.last[wall]));
  } else {
    drawExactly(walls, wall);
  }
}

// All that matters is between which beams a point lies: rough directions will do unless they are next to a beam.
void RangeRaster::drawExactly(const WallEnds & walls, std::size_t wall)
{
  const Vec2 a = view_.sensor.applyBack({walls.a_x[wall], walls.a_y[wall]});
  const Vec2 b = view_.sensor.applyBack({walls.b_x[wall], walls.b_y[wall]});
  const double beam_a = beamOf(maths::atan2(a.y, a.x));
  const double beam_b = beamOf(maths::atan2(b.y, b.x));
  const double width = beam_a < beam_b ? beam_a - beam_b + view_.beams_per_turn : beam_a - beam_b;
  if (width > kWidthMax * view_.beams_per_turn) {
    return;
  }
  anyInterval(beam_b, width, [&](int first, int last) {
    draw(wall, first, last);
    return false;
  });
}

void RangeRaster::draw(std::size_t wall, int first, int last)
{
  const double along_cosine = seen_.along_cosine[wall];
  const double along_sine = seen_.along_sine[wall];
  const double * const cosine = cosine_.data();
  const double * const sine = sine_.data();
  double * const inverse = inverse_ranges_.data();
  if (last - first >= kFewBeams) {
    drawWall(along_cosine, along_sine, cosine + first, sine + first, inverse + first, last - first + 1);
    return;
  }
  for (int i = first; i <= last; ++i) {
    const double value = along_cosine * cosine[i] + along_sine * sine[i];
    inverse[i] = value > inverse[i] ? value : inverse[i];
  }
}

void RangeRaster::addCircle(const Vec2 & centre_world, double radius)
{
  const Vec2 centre = view_.sensor.applyBack(centre_world);
  const double distance = std::sqrt(centre.x * centre.x + centre.y * centre.y);
  if (distance <= radius || distance - radius > view_.range_max) {
    return;
  }
  const double half_width = maths::asin(radius / distance);
  const double radius_squared = radius * radius;
  const double begin = beamOf(maths::atan2(centre.y, centre.x) - half_width);
  anyInterval(begin, 2.0 * half_width * view_.beams_per_radian, [&](int first, int last) {
    const double * cosine = cosine_.data();
    const double * sine = sine_.data();
    double * inverse = inverse_ranges_.data();
    for (int i = first; i <= last; ++i) {
      const double along = centre.x * cosine[i] + centre.y * sine[i];
      const double aside = centre.y * cosine[i] - centre.x * sine[i];
      const double value = 1.0 / (along - std::sqrt(std::max(radius_squared - aside * aside, 0.0)));
      inverse[i] = value > inverse[i] ? value : inverse[i];
    }
    return false;
  });
}

bool RangeRaster::couldShow(const Vec2 & centre_world, double radius) const
{
  const Vec2 centre = view_.sensor.applyBack(centre_world);
  const double squared = centre.x * centre.x + centre.y * centre.y;
  const double tangent_squared = squared - radius * radius;
  if (tangent_squared <= kSlack * squared) {
    return true;
  }
  const double nearest = std::sqrt(squared) - radius;
  if (nearest > view_.range_max) {
    return false;
  }
  // The half width is asin(radius / distance), which is below its own tangent.
  const double half_width = radius / std::sqrt(tangent_squared) + maths::kRoughAngleError;
  if (half_width >= M_PI) {
    return true;
  }
  const double begin = beamOf(maths::roughAngle(centre.y, centre.x) - half_width);
  const double threshold = (1.0 - kSlack) / nearest;
  const double * const inverse = inverseRanges();
  return anyInterval(begin, 2.0 * half_width * view_.beams_per_radian, [&](int first, int last) {
    return anyBelow(inverse + first, last - first + 1, threshold);
  });
}

double RangeRaster::sight()
{
  // Ranges only shrink while a scan is drawn: what has seen something stays so.
  while (unseeing_ < inverse_ranges_.size() && inverse_ranges_[unseeing_] != 0.0) {
    ++unseeing_;
  }
  if (unseeing_ < inverse_ranges_.size()) {
    return view_.range_max;
  }
  return std::min(view_.range_max, (1.0 + kSlack) / leastOf(inverse_ranges_.data(), inverse_ranges_.size()));
}
}  // namespace f1tenth_sim2d
