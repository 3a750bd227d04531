#pragma once

#include <deque>

#include "tyres/handling.h"

namespace f1tenth_racer
{
/// How much of the commanded acceleration a car reaches when its speed keeps falling behind: on a slippery floor the
/// wheels spin at the first start, long before a bend would show how little grip they have.
class TractionWatch
{
public:
  /// @param told  m/s^2, with which the car is to speed up
  explicit TractionWatch(double told) : told_(told) {}

  void noteCommand(const DriveCommand & command) { command_ = command; }
  /// @param speed  m/s, of the car at that time, s
  void noteSpeed(double time, double speed);

  /// Share of the commanded acceleration, at most 1; 1 until there is something to measure.
  double share() const { return share_; }

private:
  struct Speed
  {
    double time;
    double speed;
  };

  double told_;
  DriveCommand command_;
  double share_{1.0};
  std::deque<Speed> behind_;  // while the car falls behind its command
};
}  // namespace f1tenth_racer
