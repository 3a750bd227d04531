#pragma once

#include <deque>
#include <vector>

namespace move_base
{
/// How long a car's speed takes to follow what it is told, measured whenever it is told to change its speed: of some
/// delays the one at which the commands were most like the speeds that came of them.
class SpeedLag
{
public:
  /// @param expected  s, until there is something to measure
  explicit SpeedLag(double expected);

  /// @param speed  m/s, told to the car
  void noteCommand(double time, double speed);
  /// @param speed  m/s, of the car at that time
  void noteSpeed(double time, double speed);

  /// s
  double lag() const;

private:
  struct Command
  {
    double time;
    double speed;
  };

  double commandAt(double time) const;

  std::deque<Command> commands_;
  std::vector<double> errors_;  // m^2/s^2, squared and summed, of each delay
};
}  // namespace move_base
