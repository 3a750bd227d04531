#include "path/goals.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
bool cameNear(const Pose2 & from, const Pose2 & to, const Pose2 & goal, const GoalTolerance & tolerance)
{
  const double part = nearestPart(from.position(), to.position(), goal.position());
  const Vec2 nearest = from.position() + part * (to.position() - from.position());
  return distance(nearest, goal.position()) <= tolerance.distance &&
         std::abs(normalizeAngle(to.yaw - goal.yaw)) <= tolerance.yaw;
}

double placeOnPath(const Path & path, const Pose2 & goal, double near_s)
{
  const auto off = [&](const PathPoint & point) {
    return distance(point.pose, goal) + 0.01 * std::abs(point.s - near_s);
  };
  const auto nearest = std::min_element(
    path.begin(), path.end(), [&](const PathPoint & a, const PathPoint & b) { return off(a) < off(b); });
  return nearest->s;
}

bool Goals::moveAside(const Costmap & costmap, double clearance)
{
  constexpr double kStep = 0.05;     // m
  constexpr double kFarthest = 1.0;  // m
  double nearest = kFarthest;
  const Pose2 goal = *goal_;
  for (const double left : {1.0, -1.0}) {
    for (double aside = kStep; aside < nearest; aside += kStep) {
      const Pose2 beside = compose(goal, {0.0, left * aside, 0.0});
      if (costmap.wallDistance(beside.position()) <= 0.0) {
        break;
      }
      if (costmap.clearance(beside) >= clearance) {
        nearest = aside;
        goal_ = beside;
      }
    }
  }
  return nearest < kFarthest;
}

void Goals::set(const Pose2 & goal, std::vector<Pose2> next)
{
  goal_ = given_ = goal;
  next_ = std::move(next);
}

double Goals::wayToLast() const
{
  if (anyNext() && distance(next_.back(), given_) == 0.0) {
    return HUGE_VAL;
  }
  double way = 0.0;
  Pose2 from = *goal_;
  for (const Pose2 & next : next_) {
    way += distance(from, next);
    from = next;
  }
  return way;
}
}  // namespace f1tenth_racer
