#pragma once

#include <cstddef>
#include <deque>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Dead reckoning of ros_controllers' steering controllers: from where they were started, without noise.
class SteeringOdometry
{
public:
  /// @param window  number of steps over which speeds are averaged
  explicit SteeringOdometry(std::size_t window) : window_(window) {}

  /// Advances by a step of dt seconds, > 0.
  /// @param ahead  m, along the course
  /// @param turn   rad
  void advance(double ahead, double turn, double dt);

  const Pose2 & pose() const { return pose_; }
  double speed() const { return mean().ahead; }   ///< m/s
  double yawRate() const { return mean().turn; }  ///< rad/s

private:
  struct Rate
  {
    double ahead{0.0};
    double turn{0.0};
  };
  Rate mean() const;

  std::size_t window_;
  Pose2 pose_;
  std::deque<Rate> rates_;
};
}  // namespace f1tenth_sim2d
