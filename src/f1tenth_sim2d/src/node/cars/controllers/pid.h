#pragma once

namespace f1tenth_sim2d
{
/// Gains of ros_control: effort per error, per its integral, per its derivative.
struct PidGains
{
  double p{0.0};
  double i{0.0};
  double d{0.0};
  double i_clamp{0.0};  ///< greatest effort of the integral; 0: no limit
};

/// A PID controller of a joint's speed.
class Pid
{
public:
  explicit Pid(const PidGains & gains) : gains_(gains) {}

  /// @param error  wanted minus measured, rad/s
  /// @param dt     since the call before, s; > 0
  /// @param limit  greatest effort of the joint, N m
  /// @return effort, N m
  double effort(double error, double dt, double limit);
  void restart() { *this = Pid(gains_); }

private:
  PidGains gains_;
  double integral_{0.0};  // N m
  double last_error_{0.0};
  bool has_last_{false};
};
}  // namespace f1tenth_sim2d
