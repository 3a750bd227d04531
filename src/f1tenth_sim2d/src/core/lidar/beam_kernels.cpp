#include "core/lidar/beam_kernels.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/math/simd.h"

namespace f1tenth_sim2d
{
namespace
{
inline double roughBeam(const BeamView & view, double y, double x)
{
  const double beam = (maths::roughAngle(y, x) - view.angle_min) * view.beams_per_radian;
  return beam < 0.0 ? beam + view.beams_per_turn : beam;
}

inline double isTrue(bool condition)
{
  return condition ? 1.0 : 0.0;
}

/// max(value, 0), exactly, in a way that the compiler vectorizes.
inline double positivePart(double value)
{
  return 0.5 * (value + std::abs(value));
}

/// The least integer at or above a number that is not negative.
inline double roundedUp(double value)
{
  const double whole = static_cast<int>(value);
  return whole + isTrue(whole < value);
}

/// Whether a rough direction tells on which side of every beam it lies.
inline bool isBetweenBeams(const BeamView & view, double rough_beam)
{
  // A beam is not negative, and the compiler does not vectorize lround().
  const double to_beam = rough_beam - static_cast<int>(rough_beam + 0.5);  // NOLINT(bugprone-incorrect-roundings)
  return std::abs(to_beam) > maths::kRoughAngleError * view.beams_per_radian + kCornerTolerance;
}

inline float report(double range, const RangeLimits & limits)
{
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  const float seen = range <= limits.range_max ? static_cast<float>(range) : kNothing;
  return range < limits.range_min ? -kNothing : seen;
}
}  // namespace

F1TENTH_VECTORIZED
void projectWalls(const BeamView & view, const WallEnds & walls, std::size_t count, SeenWalls & seen)
{
  const BeamView v = view;
  const WallEnds w = walls;
  const double range_squared = v.range_max * v.range_max;
  for (std::size_t i = 0; i < count; ++i) {
    const double a_x = w.a_x[i] - v.sensor.x;
    const double a_y = w.a_y[i] - v.sensor.y;
    const double b_x = w.b_x[i] - v.sensor.x;
    const double b_y = w.b_y[i] - v.sensor.y;
    const double edge_x = w.b_x[i] - w.a_x[i];
    const double edge_y = w.b_y[i] - w.a_y[i];
    const double cross = a_x * edge_y - a_y * edge_x;
    const bool is_near = cross * cross <= range_squared * (edge_x * edge_x + edge_y * edge_y);
    const bool is_seen = (cross < 0.0) & is_near;
    const double left_a = v.sensor.cosine * a_y - v.sensor.sine * a_x;
    const double left_b = v.sensor.cosine * b_y - v.sensor.sine * b_x;
    const double forward_a = v.sensor.cosine * a_x + v.sensor.sine * a_y;
    const double forward_b = v.sensor.cosine * b_x + v.sensor.sine * b_y;
    const double inverse_cross = 1.0 / cross;
    seen.along_cosine[i] = (left_b - left_a) * inverse_cross;
    seen.along_sine[i] = (forward_a - forward_b) * inverse_cross;
    // The end of a wall that is not seen may be the sensor itself, which has no direction.
    seen.beam_a[i] = roughBeam(v, left_a, is_seen ? forward_a : 1.0);
    seen.beam_b[i] = roughBeam(v, left_b, is_seen ? forward_b : 1.0);
    seen.kind[i] = isTrue(is_seen);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double beam_a = seen.beam_a[i];
    const double beam_b = seen.beam_b[i];
    const double end = beam_a + kCornerTolerance;
    // Products of 0 and 1, which the compiler vectorizes, unlike "and".
    const double is_within_turn = isTrue(beam_a >= beam_b) * isTrue(end < v.beams_per_turn) *
                                  isTrue(beam_b + v.beams_per_turn > v.last_beam + kCornerTolerance) *
                                  isTrue(beam_a - beam_b <= kWidthMax * v.beams_per_turn);
    const double is_plain = is_within_turn * isTrue(isBetweenBeams(v, beam_a)) * isTrue(isBetweenBeams(v, beam_b));
    const double first = roundedUp(positivePart(beam_b - kCornerTolerance));
    const double last = static_cast<int>(std::min(end, v.last_beam));
    seen.first[i] = first;
    seen.last[i] = last;
    seen.kind[i] *= is_plain * isTrue(first <= last) * SeenWalls::kPlain + (1.0 - is_plain) * SeenWalls::kUnclear;
  }
}

F1TENTH_VECTORIZED
void drawWall(
  double along_cosine, double along_sine, const double * __restrict cosine, const double * __restrict sine,
  double * __restrict inverse, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i) {
    const double value = along_cosine * cosine[i] + along_sine * sine[i];
    inverse[i] = value > inverse[i] ? value : inverse[i];
  }
}

F1TENTH_VECTORIZED
bool anyBelow(const double * values, std::size_t count, double threshold)
{
  constexpr std::size_t kBlock = 32;  // between checks whether that is enough
  std::size_t i = 0;
  for (; i + kBlock <= count; i += kBlock) {
    std::int64_t below = 0;
    for (std::size_t k = 0; k < kBlock; ++k) {
      below |= values[i + k] < threshold ? 1 : 0;
    }
    if (below != 0) {
      return true;
    }
  }
  return std::any_of(values + i, values + count, [threshold](double value) { return value < threshold; });
}

F1TENTH_VECTORIZED
double leastOf(const double * values, std::size_t count)
{
  // The compiler would not reorder a minimum of many values, but vectorizes it when written with its vector types.
  constexpr std::size_t kLanes = 4;  // it takes wider ones apart where the unit has none
  using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Lanes least = kInfinity - Lanes{};
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    Lanes next;
    std::memcpy(&next, values + i, sizeof(next));
    least = next < least ? next : least;
  }
  double result = kInfinity;
  for (std::size_t k = 0; k < kLanes; ++k) {
    result = std::min(result, least[k]);
  }
  for (; i < count; ++i) {
    result = std::min(result, values[i]);
  }
  return result;
}

F1TENTH_VECTORIZED
void reportRanges(
  const double * __restrict inverse, const double * __restrict normal, std::size_t count, double mean, double stddev,
  const RangeLimits & limits, float * __restrict ranges)
{
  const RangeLimits l = limits;
  for (std::size_t i = 0; i < count; ++i) {
    ranges[i] = report(1.0 / inverse[i] + mean + stddev * normal[i], l);
  }
}
}  // namespace f1tenth_sim2d
