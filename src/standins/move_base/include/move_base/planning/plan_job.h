#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "move_base/global_planner.h"
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

/// One plan that is being made: at once, when it is asked for; or by a worker, on a copy of the costmap, while the car
/// drives on.
class PlanJob
{
public:
  /// @param worker  empty: plans are made at once
  PlanJob(const GlobalPlanner & planner, PlanWorker worker);
  /// Waits for the worker, which gives up soon.
  ~PlanJob() { drop(); }

  /// Whether a worker makes the plans.
  bool isBeside() const { return static_cast<bool>(worker_); }
  /// Whether nothing is in progress, not even a plan that is no longer wanted.
  bool isIdle();
  /// To be called when idle.
  /// @param time  s
  void begin(const Costmap & costmap, const PlanRequest & request, double time);
  /// The result, once.
  /// @param time  s
  std::optional<PlanAnswer> answer(double time);
  /// The plan is no longer wanted.
  void drop();
  /// How long a plan by a worker may take, s, judging by the last one; 0 for plans that are made at once.
  double timeNeeded() const { return isBeside() ? time_needed_ : 0.0; }

private:
  const GlobalPlanner & planner_;
  PlanWorker worker_;
  std::future<PlanAnswer> future_;
  std::shared_ptr<std::atomic<bool>> dropped_;
  double begun_{0.0};
  double time_needed_;
};
}  // namespace move_base
