#include "way.h"

#include "traffic/passing.h"

namespace move_base
{
namespace
{
constexpr double kLookInterval = 0.1;   // s between looks for a way past others
constexpr double kStoppedSpeed = 0.05;  // m/s
}  // namespace

void Way::start(Plan plan, bool races, const Scene & scene)
{
  races_ = races;
  next_look_ = scene.time;
  take(std::move(plan), scene.costmap);
}

void Way::take(Plan plan, const Costmap & costmap)
{
  plan_ = std::move(plan);
  changed_ = true;
  follower_.setPath(plan_.path, costmap);
}

bool Way::passOthers(const Scene & scene)
{
  if (!follower_.hindered(scene.car, scene.costmap, scene.others)) {
    return true;
  }
  if (scene.time < next_look_) {
    return false;
  }
  next_look_ = scene.time + kLookInterval;
  const PlanRequest request = requests_.from(scene.car, 0.0);
  if (request.lead.empty() || !request.race_line) {
    return false;
  }
  auto past = planPast(
    {scene.costmap, options_.planner, follower_.options().limits, plan_, request, scene.others,
     follower_.placeOf(scene.car), scene.car.speed});
  if (past) {
    take(std::move(*past), scene.costmap);
  }
  return past.has_value();
}

bool Way::isOver(const FollowStep & step, const CarState & car, double time_needed) const
{
  const double left = plan_.goal_s - step.position.s;
  const bool approaches = races_ && !requests_.passes() && !requests_.isFar(left, car.speed, time_needed);
  const bool passed = left < -requests_.tolerance().distance;
  const bool missed = step.at_end && std::abs(car.speed) < kStoppedSpeed;
  return step.lost || step.blocked || missed || passed || approaches;
}
}  // namespace move_base
