#pragma once

#include <algorithm>
#include <cmath>

#include "control/path_follower.h"
#include "roads.h"

namespace f1tenth_racer::testing
{
/// A car for closed loops: turns its wheels and changes its speed no faster than the real one, and slips a little.
class KinematicCar
{
public:
  explicit KinematicCar(const Pose2 & pose) { state_.pose = pose; }

  const CarState & state() const { return state_; }

  void drive(const DriveCommand & command, double duration)
  {
    constexpr double kStep = 0.001;
    for (double t = 0.0; t < duration - 0.5 * kStep; t += kStep) {
      const double wanted = command.speed == 0.0 ? 0.0 : std::atan(kWheelbase * command.curvature);
      steering_ += std::clamp(wanted - steering_, -3.2 * kStep, 3.2 * kStep);
      steering_ = std::clamp(steering_, -0.4189, 0.4189);
      state_.speed += std::clamp(10.0 * (command.speed - state_.speed), -9.5, 9.5) * kStep;
      const double understeer = 1.0 + 0.0085 * state_.speed * state_.speed;
      state_.pose = advance(state_.pose, state_.speed * kStep, std::tan(steering_) / kWheelbase / understeer);
    }
  }

private:
  static constexpr double kWheelbase = 0.3302;
  CarState state_;
  double steering_{0.0};
};
}  // namespace f1tenth_racer::testing
