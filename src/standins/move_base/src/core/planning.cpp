#include "planning.h"

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

std::optional<PlanAnswer> Planning::answer(const CarState & car, double time, const Costmap & costmap)
{
  if (job_.isIdle() && !ask(car, time, costmap)) {
    return std::nullopt;
  }
  std::optional<PlanAnswer> answer = job_.answer(time);
  if (answer) {
    drive_on_until_ = time;
  }
  return answer;
}

bool Planning::ask(const CarState & car, double time, const Costmap & costmap)
{
  if (!mayAsk(time)) {
    return false;
  }
  next_plan_ = time + kRetryInterval;
  const PlanRequest request = requests_.from(car, timeNeeded());
  drive_on_until_ = time + (request.lead.empty() ? 0.0 : requests_.leadTime(timeNeeded()));
  job_.begin(costmap, request, time);
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
