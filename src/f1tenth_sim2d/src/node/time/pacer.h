#pragma once

#include <ros/time.h>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// When, in wall time, a simulated time is due. Steps follow an absolute schedule: delays do not accumulate, and a short
/// hold-up is caught up with. A simulation that has fallen behind by more than kMaxLag goes on from there.
class Pacer
{
public:
  static constexpr double kMaxLag = 0.25;  ///< s, wall time

  /// @param factor  simulated seconds per wall second, > 0
  explicit Pacer(double factor);

  /// Simulated time `now` is due at wall time `wall_now`, and all others accordingly.
  void start(SimTime now, const ros::WallTime & wall_now);
  /// Wall time at which `time` is due, for somebody who asks at wall_now.
  ros::WallTime due(SimTime time, const ros::WallTime & wall_now);

private:
  const double factor_;
  SimTime start_{0};
  ros::WallTime wall_start_;
};
}  // namespace f1tenth_sim2d
