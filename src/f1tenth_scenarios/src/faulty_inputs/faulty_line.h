#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace f1tenth_scenarios
{
/// What happens to the messages that arrive in [at, until) of simulated time (s).
struct InputFault
{
  double at;
  double until;
  std::optional<double> delay;  // s; without one they are lost
};

/// A line over which messages come late or not at all. Their order is kept: when a delay is over, what was held back
/// comes at once. Faults must not overlap.
template <class Message>
class FaultyLine
{
public:
  explicit FaultyLine(std::vector<InputFault> faults) : faults_(std::move(faults)) {}

  /// A message arrives at now (s).
  void take(double now, Message message)
  {
    const InputFault * fault = faultAt(now);
    if (!fault) {
      held_.push_back({now, std::move(message)});
    } else if (fault->delay) {
      held_.push_back({now + *fault->delay, std::move(message)});
    }
  }

  /// The messages that leave the line up to now (s), in the order of their arrival.
  std::vector<Message> release(double now)
  {
    const bool delays = faultAt(now) != nullptr && faultAt(now)->delay;
    std::vector<Message> released;
    while (!held_.empty() && (!delays || held_.front().due <= now + kTolerance)) {
      released.push_back(std::move(held_.front().message));
      held_.pop_front();
    }
    return released;
  }

private:
  struct Held
  {
    double due;  // s
    Message message;
  };
  static constexpr double kTolerance = 1e-6;  // s; far below a period, far above rounding errors of sums

  const InputFault * faultAt(double now) const
  {
    for (const InputFault & fault : faults_) {
      if (now + kTolerance >= fault.at && now + kTolerance < fault.until) {
        return &fault;
      }
    }
    return nullptr;
  }

  std::vector<InputFault> faults_;
  std::deque<Held> held_;
};
}  // namespace f1tenth_scenarios
