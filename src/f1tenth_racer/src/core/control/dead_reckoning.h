#pragma once

#include <deque>

#include "tyres/handling.h"

namespace f1tenth_racer
{
/// Where the car is according to the commands that it has been given since it was last seen.
class DeadReckoning
{
public:
  /// Notes a command to the car, time in s, not before the commands already noted.
  void note(double time, const DriveCommand & command);
  void clear() { commands_.clear(); }

  /// The car's motion at a time, s, not before its pose was seen and its speed was measured. Wheels are taken to turn
  /// at once; the speed follows with a lag.
  CarState predict(const CarState & car, double seen, double measured, double time) const;

private:
  CarState drivenOn(CarState car, double from, double to) const;

  struct Entry
  {
    double time;
    DriveCommand command;
  };

  std::deque<Entry> commands_;
};
}  // namespace f1tenth_racer
