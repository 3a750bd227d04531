#pragma once

#include <algorithm>
#include <cmath>
#include <deque>

#include "control/path_follower.h"
#include "roads.h"

namespace f1tenth_racer::testing
{
/// A single-track car whose tyres slip and whose load moves when it brakes, after CommonRoad's "Vehicle Models", with the
/// numbers of the simulator's car. The pose is that of the rear axle.
class SlidingCar
{
public:
  SlidingCar(const Pose2 & pose, double speed, double friction, double latency)
  : pose_(pose), v_(speed), friction_(friction), latency_(latency)
  {
  }

  CarState state() const { return {pose_, v_}; }
  double yawRate() const { return r_; }
  double lateralAcceleration() const { return lateral_; }

  void drive(const DriveCommand & command, double duration)
  {
    constexpr double kStep = 0.001;
    for (double t = 0.0; t < duration - 0.5 * kStep; t += kStep) {
      pending_.push_back(command);
      if (static_cast<double>(pending_.size()) > latency_ / kStep) {
        active_ = pending_.front();
        pending_.pop_front();
      }
      step(kStep);
    }
  }

private:
  static constexpr double kFront = 0.15875;    // m, centre of mass to front axle
  static constexpr double kRear = 0.17145;     // m
  static constexpr double kHeight = 0.074;     // m
  static constexpr double kGyration = 0.0126;  // m^2, yaw inertia over mass
  static constexpr double kGravity = 9.81;     // m/s^2

  void step(double dt)
  {
    const double wheelbase = kFront + kRear;
    const double turn = std::atan(wheelbase * active_.curvature) - steering_;
    steering_ += std::clamp(turn, -3.2 * dt, 3.2 * dt);
    const double acceleration = std::clamp(10.0 * (active_.speed - v_), -9.51, 9.51);
    const double front_load = (kGravity * kRear - acceleration * kHeight) / wheelbase;
    const double rear_load = (kGravity * kFront + acceleration * kHeight) / wheelbase;
    const double front = friction_ * 4.718 * front_load * (steering_ - (y_ + kFront * r_) / v_);
    const double rear = friction_ * 5.4562 * rear_load * (kRear * r_ - y_) / v_;
    lateral_ = front + rear;
    y_ += (lateral_ - v_ * r_) * dt;
    r_ += (kFront * front - kRear * rear) / kGyration * dt;
    v_ += acceleration * dt;
    const double aside = y_ - kRear * r_;
    pose_.x += (v_ * std::cos(pose_.yaw) - aside * std::sin(pose_.yaw)) * dt;
    pose_.y += (v_ * std::sin(pose_.yaw) + aside * std::cos(pose_.yaw)) * dt;
    pose_.yaw += r_ * dt;
  }

  Pose2 pose_;
  double v_;
  double friction_;
  double latency_;
  double steering_{0.0};
  double y_{0.0};  // m/s, of the centre of mass to the left
  double r_{0.0};  // rad/s
  double lateral_{0.0};
  DriveCommand active_{v_, 0.0};
  std::deque<DriveCommand> pending_;
};
}  // namespace f1tenth_racer::testing
