#include "move_base/planning/planning.h"

namespace move_base
{
namespace
{
constexpr double kRetryInterval = 0.5;     // s between plans for the same goal: the world changes no faster
constexpr double kNotTakenInterval = 0.1;  // s, the same when there was one that the car could not switch to
}  // namespace

void Planning::startAgain(double time)
{
  retries_ = 0;
  last_valid_ = next_plan_ = time;
}

std::optional<PlanAnswer> Planning::answer(const Situation & situation)
{
  if (job_.isIdle() && !ask(situation)) {
    return std::nullopt;
  }
  std::optional<PlanAnswer> answer = job_.answer(situation.time);
  if (answer) {
    drive_on_until_ = situation.time;
  }
  return answer;
}

bool Planning::ask(const Situation & situation)
{
  if (!mayAsk(situation.time)) {
    return false;
  }
  next_plan_ = situation.time + kRetryInterval;
  const PlanRequest request = local_.request(situation);
  drive_on_until_ = situation.time + request.lead_time;
  job_.begin(situation.costmap, request, situation.time);
  return true;
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
