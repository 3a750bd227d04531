#include "move_base/planning/planning.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace move_base
{
namespace
{
constexpr double kRetryInterval = 0.5;     // s between plans for the same goal: the world changes no faster
constexpr double kNotTakenInterval = 0.1;  // s, the same when there was one that the car could not switch to
constexpr double kLeastTime = 0.1;         // s, that a plan by a worker is taken to need
constexpr double kMostTime = 1.0;          // s, the same
constexpr double kReserve = 2.0;           // times what the last plan took
}  // namespace

void Planning::startAgain(double time)
{
  retries_ = 0;
  last_valid_ = next_plan_ = time;
}

void Planning::drop()
{
  if (future_.valid()) {
    *dropped_ = true;
  }
}

std::optional<PlanAnswer> Planning::answer(const Situation & situation)
{
  if (isIdle() && mayAsk(situation.time)) {
    ask(situation);
  }
  if (isIdle() || *dropped_ || !isOver()) {
    return std::nullopt;
  }
  time_needed_ = std::clamp(kReserve * (situation.time - asked_), kLeastTime, kMostTime);
  drive_on_until_ = situation.time;
  return future_.get();
}

// A plan that is made at once is made when its result is asked for.
bool Planning::isOver() const
{
  return future_.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
}

// Whether nothing is in progress, not even a plan that is no longer wanted.
bool Planning::isIdle()
{
  if (future_.valid() && *dropped_ && isOver()) {
    future_ = {};
  }
  return !future_.valid();
}

void Planning::ask(const Situation & situation)
{
  PlanRequest request = local_.request(situation);
  asked_ = situation.time;
  next_plan_ = situation.time + kRetryInterval;
  drive_on_until_ = situation.time + request.lead_time;
  dropped_ = std::make_shared<std::atomic<bool>>(false);
  if (!worker_) {
    future_ =
      std::async(std::launch::deferred, [this, &map = situation.costmap, request] { return planOn(map, request); });
    return;
  }
  request.dropped = dropped_;
  future_ = worker_([this, request = std::move(request), map = std::make_shared<const Costmap>(situation.costmap)] {
    return planOn(*map, request);
  });
}

PlanAnswer Planning::planOn(const Costmap & costmap, const PlanRequest & request) const
{
  PlanAnswer answer{global_.makePlan(costmap, request), {}};
  const bool dropped = request.dropped && *request.dropped;
  if (!answer.plan.found() && !dropped) {
    answer.obstruction = obstructionOf(costmap, request, answer.plan.status);
  }
  return answer;
}

void Planning::succeeded(double time, bool taken)
{
  next_plan_ = taken ? next_plan_ : time + kNotTakenInterval;
  no_plan_because_.clear();
  retries_ = 0;
  last_valid_ = time;
}

void Planning::refused(double time)
{
  next_plan_ = time + kNotTakenInterval;
}

void Planning::failed(const std::string & because)
{
  no_plan_because_ = because;
  ++retries_;
}

bool Planning::isSpent(double time) const
{
  const bool often = options_.max_planning_retries >= 0 && retries_ > options_.max_planning_retries;
  return often || time > last_valid_ + options_.planner_patience;
}

bool Planning::isDue(double time) const
{
  return mayAsk(time) && options_.planner_frequency > 0.0 && time >= last_valid_ + 1.0 / options_.planner_frequency;
}
}  // namespace move_base
