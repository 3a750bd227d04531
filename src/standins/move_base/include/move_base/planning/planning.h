#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "move_base/local_planner.h"
#include "move_base/planning/navigator_options.h"
#include "move_base/planning/obstruction.h"

namespace move_base
{
/// A plan, or why there is none.
struct PlanAnswer
{
  Plan plan;
  Obstruction obstruction;  ///< unless a plan was found
};

/// Runs a job elsewhere, as std::async does.
using PlanWorker = std::function<std::future<PlanAnswer>(std::function<PlanAnswer()>)>;

/// Plans for the goal, asked for again and again until there is one or patience is spent: made at once, when they are
/// asked for; or by a worker, on a copy of the costmap, while the car drives on.
class Planning
{
public:
  /// @param local   says what to ask for
  /// @param worker  empty: plans are made at once
  Planning(
    const NavigatorOptions & options, const GlobalPlanner & global, const LocalPlanner & local, PlanWorker worker)
  : options_(options), global_(global), local_(local), worker_(std::move(worker))
  {
  }
  /// Waits for the worker, which gives up soon.
  ~Planning() { drop(); }

  /// Asks at once the next time, and is patient again.
  /// @param time  s
  void startAgain(double time);
  /// What is being planned is no longer wanted.
  void drop();

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
  /// How long a plan by a worker may take, s, judging by the last one; 0 for plans that are made at once.
  double timeNeeded() const { return worker_ ? time_needed_ : 0.0; }

private:
  bool isOver() const;
  bool isIdle();
  void ask(const Situation & situation);
  PlanAnswer planOn(const Costmap & costmap, const PlanRequest & request) const;

  const NavigatorOptions & options_;
  const GlobalPlanner & global_;
  const LocalPlanner & local_;
  PlanWorker worker_;
  std::future<PlanAnswer> future_;
  std::shared_ptr<std::atomic<bool>> dropped_;
  double asked_{0.0};
  double time_needed_{0.1};
  int retries_{0};
  double last_valid_{0.0};
  double next_plan_{0.0};
  double drive_on_until_{0.0};
  std::string no_plan_because_;
};
}  // namespace move_base
