#include "control/dead_reckoning.h"

#include <workspace_support/maths/exponential.h>

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kMemory = 3.0;          // s; a car that has not been seen for longer counts as standing
constexpr double kReckoningStep = 0.02;  // s
constexpr double kSpeedLag = 0.1;        // s, time constant of a car's speed

CarState drive(CarState car, const DriveCommand & command, double duration)
{
  const int steps = std::max(1, static_cast<int>(std::ceil(duration / kReckoningStep - 1e-9)));
  const double step = duration / steps;
  const double part = 1.0 - maths::exp(-step / kSpeedLag);
  for (int i = 0; i < steps; ++i) {
    const double before = car.speed;
    car.speed += part * (command.speed - car.speed);
    car.pose = advance(car.pose, 0.5 * (before + car.speed) * step, command.curvature);
  }
  return car;
}
}  // namespace

void DeadReckoning::note(double time, const DriveCommand & command)
{
  commands_.push_back({time, command});
  while (commands_.front().time < time - kMemory) {
    commands_.pop_front();
  }
}

CarState DeadReckoning::predict(const CarState & car, double seen, double measured, double time) const
{
  CarState state{car.pose, drivenOn(car, measured, seen).speed, car.yaw_rate};
  state = drivenOn(state, seen, time);
  if (measured > seen) {
    state.speed = drivenOn(car, measured, time).speed;
  }
  return state;
}

CarState DeadReckoning::drivenOn(CarState car, double from, double to) const
{
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const double begin = std::max(commands_[i].time, from);
    const double end = i + 1 < commands_.size() ? std::min(commands_[i + 1].time, to) : to;
    if (end > begin) {
      car = drive(car, commands_[i].command, end - begin);
    }
  }
  return car;
}
}  // namespace f1tenth_racer
