#pragma once

#include <deque>

#include <move_base/map/geometry.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// How far a car's rear axle drifts outwards in bends, measured from where it points and where it goes.
class SlipWatch
{
public:
  /// @param expected  rad per m/s^2 of lateral acceleration, until there is something to measure
  explicit SlipWatch(double expected) : slip_times_acceleration_(kExpectation * expected) {}

  /// @param pose  of the rear axle at that time, s
  void note(double time, const Pose2 & pose);

  /// Whether what has been measured in bends counts far more than what was expected.
  bool hasFelt() const { return squared_acceleration_ > kFelt * kExpectation; }
  /// rad per m/s^2
  double gradient() const { return slip_times_acceleration_ / squared_acceleration_; }

private:
  static constexpr double kExpectation = 10.0;  // m^2/s^4, weight of what is expected: a moment of a bend outweighs it
  static constexpr double kFelt = 30.0;

  struct Place
  {
    double time;
    Pose2 pose;
  };

  std::deque<Place> places_;
  double slip_times_acceleration_;
  double squared_acceleration_{kExpectation};
};
}  // namespace f1tenth_racer
