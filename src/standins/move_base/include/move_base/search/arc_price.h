#pragma once

#include "move_base/map/costmap.h"
#include "move_base/search/curves.h"

namespace move_base
{
/// The clearance that plans must keep: as wanted, but near start and goal no more than these have themselves.
class ClearanceRule
{
public:
  ClearanceRule(const Costmap & costmap, const Pose2 & start, const Pose2 & goal, double wanted);

  double startClearance() const { return start_clearance_; }
  double goalClearance() const { return goal_clearance_; }
  double at(const Vec2 & point) const;
  /// m, it is nowhere more.
  double most() const { return wanted_; }

private:
  double wanted_;
  Vec2 start_;
  Vec2 goal_;
  double start_clearance_;
  double goal_clearance_;
};

/// Cost of driving along an arc, in metres of free road: its length and what obstacles near it add.
/// Infinite where the rule is broken.
double priceOf(const Costmap & costmap, const ClearanceRule & rule, const Pose2 & start, const Arc & arc);
}  // namespace move_base
