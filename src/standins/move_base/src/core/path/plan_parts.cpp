#include "path/plan_parts.h"

#include <algorithm>

namespace move_base
{
double placeOnPath(const Path & path, const Pose2 & goal, double near_s)
{
  const auto off = [&](const PathPoint & point) {
    return distance(point.pose, goal) + 0.01 * std::abs(point.s - near_s);
  };
  const auto nearest = std::min_element(
    path.begin(), path.end(), [&](const PathPoint & a, const PathPoint & b) { return off(a) < off(b); });
  return nearest->s;
}

void prepend(const Path & lead, Plan & plan)
{
  if (lead.empty()) {
    return;
  }
  const double shift = length(lead) - plan.path.front().s;
  Path path = lead;
  const double start_s = lead.front().s;
  for (PathPoint & point : path) {
    point.s -= start_s;
  }
  if (!plan.path.front().reverse) {
    path.pop_back();
  }
  for (PathPoint & point : plan.path) {
    point.s += shift;
    path.push_back(point);
  }
  plan.path = std::move(path);
  plan.goal_s += shift;
}
}  // namespace move_base
