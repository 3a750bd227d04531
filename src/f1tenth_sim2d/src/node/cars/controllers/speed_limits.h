#pragma once

#include <optional>

namespace f1tenth_sim2d
{
/// Bounds of ros_controllers' speed limiters for one axis of a command, and for how fast it may change.
struct SpeedLimits
{
  struct Range
  {
    double least;
    double greatest;
  };
  std::optional<Range> velocity;      ///< m/s or rad/s
  std::optional<Range> acceleration;  ///< m/s^2 or rad/s^2
  std::optional<Range> jerk;          ///< m/s^3 or rad/s^3
};

/// The part of a command that is allowed.
/// @param last    what was allowed dt seconds before
/// @param before  what was allowed dt seconds before that
double limited(double wanted, double last, double before, double dt, const SpeedLimits & limits);
}  // namespace f1tenth_sim2d
