#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/math/planar_pose.h"

/// The inner loops of the lidar, over walls and over beams. Arrays never overlap.
namespace f1tenth_sim2d
{
/// In beams. A beam through a corner hits both walls that meet there, whatever the rounding: otherwise it could slip
/// through between them.
constexpr double kCornerTolerance = 1e-9;
/// Turns. More than half a turn between the ends of a wall is rounding of a wall seen edge-on.
constexpr double kWidthMax = 0.5 + 1e-6;

/// From where walls are seen, and how directions are counted in beams.
struct BeamView
{
  Transform2 sensor;  ///< in the world
  double range_max;   ///< m
  double angle_min;   ///< rad, of beam 0
  double beams_per_radian;
  double beams_per_turn;
  double last_beam;
};

/// Walls that are drawn together, as arrays that a vector unit can stream.
struct WallBatch
{
  static constexpr std::size_t kSize = 64;
  using Values = std::array<double, kSize>;

  // Ends, m, relative to the sensor, in the directions of the world.
  Values a_x;
  Values a_y;
  Values b_x;
  Values b_y;
  Values cross;  ///< m^2, a x (b - a)
  // Computed from them by projectWalls().
  Values beam_a;  ///< direction of a in beams, within [0, beams_per_turn), to within kRoughAngleError
  Values beam_b;
  Values along_cosine;  ///< 1/m: the inverse range is along_cosine cos + along_sine sin
  Values along_sine;
  // Of a plain wall (is_plain 1, else 0): the beams that it covers, none if first > last. A wall is not plain if one of
  // its ends is so close to a beam that its rough direction does not tell on which side, or if it leaves the field of
  // view and comes back.
  Values first;
  Values last;
  Values is_plain;
};

/// Ends of walls, m, in the world.
struct WallEnds
{
  const double * a_x;
  const double * a_y;
  const double * b_x;
  const double * b_y;
};

/// For each wall a x (b - a), m^2, with its ends relative to a point: negative if the wall turns its right side to the
/// point and its line passes within the range, m; else 0.
void crossOfFacing(const Vec2 & point, double range, const WallEnds & walls, std::size_t count, double * cross_or_zero);

void projectWalls(const BeamView & view, WallBatch & batch, std::size_t count);

/// inverse[i] = max(inverse[i], along_cosine cosine[i] + along_sine sine[i])
void drawWall(
  double along_cosine, double along_sine, const double * cosine, const double * sine, double * inverse,
  std::size_t count);

/// Whether any value is below a threshold.
bool anyBelow(const double * values, std::size_t count, double threshold);

/// The least of values, +inf if there are none.
double leastOf(const double * values, std::size_t count);

/// What a lidar reports beyond its limits, REP-117: -inf below range_min, +inf above range_max; m.
struct RangeLimits
{
  double range_min;
  double range_max;
};

/// Ranges, m, of inverse ranges, 1/m, with noise added: mean + stddev * normal[i], m.
void reportRanges(
  const double * inverse, const double * normal, std::size_t count, double mean, double stddev,
  const RangeLimits & limits, float * ranges);
}  // namespace f1tenth_sim2d
