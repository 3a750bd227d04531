#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/models/body_state.h"

namespace f1tenth_sim2d
{
/// m/s^2, in the tyre loads of the models, whatever the world's gravity: their coefficients were identified with it.
constexpr double kGravity = 9.81;

/// What the actuators do, constant over a step and within the car's limits.
struct SteeredInput
{
  double steering_rate{0.0};  ///< rad/s
  double acceleration{0.0};   ///< m/s^2, that motor and brakes are asked for
};

/// Circumferential speeds of the wheels of a single track, m/s.
struct AxleSpeeds
{
  double front{0.0};
  double rear{0.0};
  double driven{0.0};  ///< mean of the axles that the motor drives
};

/// How a car with a steered front axle moves on the ground when nothing touches it.
class SteeredModel
{
public:
  virtual ~SteeredModel() = default;
  virtual std::unique_ptr<SteeredModel> clone() const = 0;

  /// The car was put somewhere: the model's own state is set from this one.
  virtual void restart(const BodyState & /*state*/) {}

  /// Advances state by dt, s.
  virtual void advance(BodyState & state, const SteeredInput & input, double dt) = 0;

  /// Speeds of wheels that may slip along their track; none for a model whose wheels roll.
  virtual std::optional<AxleSpeeds> axleSpeeds() const { return std::nullopt; }
};

/// Calls advance(step) for equal parts of a step of dt seconds that are no longer than 1 ms: the stiffest case of the
/// single-track model (v = 0.1 m/s) is stable up to 2.5 ms.
template <typename Advance>
void inShortSteps(double dt, Advance advance)
{
  constexpr double kLongest = 0.001;  // s
  const int count = std::max(1, static_cast<int>(std::ceil(dt / kLongest - 1e-9)));
  for (int i = 0; i < count; ++i) {
    advance(dt / count);
  }
}
}  // namespace f1tenth_sim2d
