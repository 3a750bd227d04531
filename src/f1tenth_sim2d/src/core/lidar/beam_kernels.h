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

/// Ends of walls, m, in the world.
struct WallEnds
{
  const double * a_x;
  const double * a_y;
  const double * b_x;
  const double * b_y;
};

/// Walls as a lidar sees them, as arrays that a vector unit can stream.
struct SeenWalls
{
  static constexpr std::size_t kMost = 64;
  using Values = std::array<double, kMost>;
  /// kHidden: no beam meets it. kPlain: the beams from `first` to `last` do. kUnclear: one of its ends is so close to a
  /// beam that its rough direction does not tell on which side, or it leaves the field of view and comes back.
  static constexpr double kHidden = 0.0;
  static constexpr double kPlain = 1.0;
  static constexpr double kUnclear = 2.0;

  Values beam_a;  ///< direction of a in beams, within [0, beams_per_turn), to within kRoughAngleError
  Values beam_b;
  Values along_cosine;  ///< 1/m: the inverse range is along_cosine cos + along_sine sin
  Values along_sine;
  Values first;
  Values last;
  Values kind;
};

/// How walls are seen that turn their right sides to the sensor and whose lines pass within the range; others are
/// hidden.
/// @param count  at most SeenWalls::kMost
void projectWalls(const BeamView & view, const WallEnds & walls, std::size_t count, SeenWalls & seen);

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
