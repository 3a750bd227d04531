#include "move_base/search/arc_price.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace move_base
{
namespace
{
// A fifth of the car's length: no obstacle fits between two checks of the discs.
constexpr double kCheckSpacing = 0.1;
// How far from a start or goal near an obstacle the car may take to get away from it.
constexpr double kReliefRadius = 1.0;
// Interpolated distances of the same place differ by this much between two checks.
constexpr double kTolerance = 0.01;
}  // namespace

ClearanceRule::ClearanceRule(const Costmap & costmap, const Pose2 & start, const Pose2 & goal, double wanted)
: wanted_(wanted),
  start_(start.position()),
  goal_(goal.position()),
  start_clearance_(costmap.clearance(start)),
  goal_clearance_(costmap.clearance(goal))
{
}

double ClearanceRule::at(const Vec2 & point) const
{
  double required = wanted_;
  if (start_clearance_ < wanted_ && distance(point, start_) < kReliefRadius) {
    required = std::min(required, std::max(0.0, start_clearance_ - kTolerance));
  }
  if (goal_clearance_ < wanted_ && distance(point, goal_) < kReliefRadius) {
    required = std::min(required, std::max(0.0, goal_clearance_ - kTolerance));
  }
  return required;
}

double priceOf(const Costmap & costmap, const ClearanceRule & rule, const Pose2 & start, const Arc & arc)
{
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(arc.length) / kCheckSpacing - 1e-9)));
  const double step = arc.length / steps;
  double price = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const Pose2 pose = advance(start, i * step, arc.curvature);
    if (costmap.isFarFromAll(pose, rule.most())) {
      price += std::abs(step);
      continue;
    }
    const double clearance = costmap.clearance(pose);
    if (clearance < rule.at(pose.position())) {
      return std::numeric_limits<double>::infinity();
    }
    price += std::abs(step) * (1.0 + costmap.proximityCost(clearance));
  }
  return price;
}
}  // namespace move_base
