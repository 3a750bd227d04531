#include "move_base/planning/plan_job.h"

#include <algorithm>
#include <utility>

namespace move_base
{
namespace
{
constexpr double kLeastTime = 0.1;  // s
constexpr double kMostTime = 1.0;   // s
constexpr double kReserve = 2.0;    // times what the last plan took

PlanAnswer answerTo(const GlobalPlanner & planner, const Costmap & costmap, const PlanRequest & request)
{
  PlanAnswer answer{planner.makePlan(costmap, request), {}};
  const bool dropped = request.dropped && *request.dropped;
  if (!answer.plan.found() && !dropped) {
    answer.obstruction = obstructionOf(costmap, request, answer.plan.status);
  }
  return answer;
}
}  // namespace

PlanJob::PlanJob(const GlobalPlanner & planner, PlanWorker worker)
: planner_(planner), worker_(std::move(worker)), time_needed_(kLeastTime)
{
}

bool PlanJob::isIdle()
{
  if (future_.valid() && *dropped_ && future_.wait_for(std::chrono::seconds(0)) != std::future_status::timeout) {
    future_ = {};
  }
  return !future_.valid();
}

void PlanJob::begin(const Costmap & costmap, const PlanRequest & request, double time)
{
  begun_ = time;
  dropped_ = std::make_shared<std::atomic<bool>>(false);
  if (!isBeside()) {
    future_ =
      std::async(std::launch::deferred, [this, &costmap, request] { return answerTo(planner_, costmap, request); });
    return;
  }
  PlanRequest own = request;
  own.dropped = dropped_;
  future_ = worker_([this, own = std::move(own), map = std::make_shared<const Costmap>(costmap)] {
    return answerTo(planner_, *map, own);
  });
}

std::optional<PlanAnswer> PlanJob::answer(double time)
{
  if (isIdle() || *dropped_ || future_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) {
    return std::nullopt;
  }
  time_needed_ = std::clamp(kReserve * (time - begun_), kLeastTime, kMostTime);
  return future_.get();
}

void PlanJob::drop()
{
  if (future_.valid()) {
    *dropped_ = true;
  }
}
}  // namespace move_base
