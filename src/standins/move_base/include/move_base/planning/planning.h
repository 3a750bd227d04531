#pragma once

#include <optional>
#include <string>

#include "move_base/local_planner.h"
#include "move_base/planning/navigator_options.h"
#include "move_base/planning/plan_job.h"

namespace move_base
{
/// Plans for the goal, asked for again and again until there is one or patience is spent.
class Planning
{
public:
  /// @param local  says what to ask for
  Planning(
    const NavigatorOptions & options, const GlobalPlanner & global, const LocalPlanner & local, PlanWorker worker)
  : options_(options), local_(local), job_(global, std::move(worker))
  {
  }

  /// Asks at once the next time, and is patient again.
  /// @param time  s
  void startAgain(double time);
  /// What is being planned is no longer wanted.
  void drop() { job_.drop(); }

  /// The result of planning; a plan is asked for when it is time to.
  std::optional<PlanAnswer> answer(const Situation & situation);
  /// Whether the plan that is being made keeps the car's way until then: so long the car may drive on, later it brakes.
  bool leavesWayAt(double time) const { return time < drive_on_until_; }

  /// Notes that there is a plan that the car can drive.
  /// @param taken  whether it does; if not, another is asked for soon
  void succeeded(double time, bool taken);
  /// Notes that there is one that the car cannot switch to yet: another is asked for soon.
  void refused(double time);
  /// Notes why there is none.
  void failed(const std::string & because);
  /// Whether it has failed too often, or for too long.
  bool isSpent(double time) const;
  /// Why there is no plan, or empty.
  const std::string & noPlanBecause() const { return no_plan_because_; }
  void forgetReason() { no_plan_because_.clear(); }

  /// Whether another plan may be asked for.
  bool mayAsk(double time) const { return time >= next_plan_; }
  void askFrom(double time) { next_plan_ = time; }
  /// Whether plans are made from time to time, and it is time.
  bool isDue(double time) const;
  /// s, how long a plan may take
  double timeNeeded() const { return job_.timeNeeded(); }

private:
  bool ask(const Situation & situation);

  const NavigatorOptions & options_;
  const LocalPlanner & local_;
  PlanJob job_;
  int retries_{0};
  double last_valid_{0.0};
  double next_plan_{0.0};
  double drive_on_until_{0.0};
  std::string no_plan_because_;
};
}  // namespace move_base
