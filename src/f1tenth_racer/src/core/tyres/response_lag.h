#pragma once

#include <deque>
#include <vector>

namespace f1tenth_racer
{
/// How long a car takes to follow its commands, in speed or steering, measured whenever they change: of several delays
/// the one at which the commands best match the response.
class ResponseLag
{
public:
  /// @param least_change  by which a command must change to be informative
  explicit ResponseLag(double least_change);

  /// @param value  commanded to the car at that time, s
  void noteCommand(double time, double value);
  /// @param value  of the car at that time, s
  void noteAnswer(double time, double value);

  /// @param expected  s, until there is something to measure
  /// @return s
  double lag(double expected) const;

private:
  struct Command
  {
    double time;
    double value;
  };

  double commandAt(double time) const;

  double least_change_;
  std::deque<Command> commands_;
  std::vector<double> errors_;  // squared and summed, of each delay
  double expectation_;          // squared error taken for a delay one step beside the expected one
};
}  // namespace f1tenth_racer
