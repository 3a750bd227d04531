#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <move_base/map/costmap.h>
#include <move_base/map/geometry.h>
#include <move_base/path/path.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// How near to a goal is near enough.
struct GoalTolerance
{
  double distance{0.2};  ///< m
  double yaw{0.2};       ///< rad
};

/// Whether a car that drove straight from one pose to another came near enough to a goal: a fast one may be near it
/// between two cycles only.
bool cameNear(const Pose2 & from, const Pose2 & to, const Pose2 & goal, const GoalTolerance & tolerance);

/// How far along the path the goal is, m: at its nearest point, among those near to near_s.
double placeOnPath(const Path & path, const Pose2 & goal, double near_s);

/// The goal that is pursued, and those that are known to follow it.
class Goals
{
public:
  /// In place of any other.
  void set(const Pose2 & goal, std::vector<Pose2> next);
  void clear() { goal_.reset(); }
  bool any() const { return goal_.has_value(); }
  const Pose2 & front() const { return *goal_; }

  /// Puts the goal elsewhere; what follows stays.
  void move(const Pose2 & goal) { goal_ = goal; }
  /// Moves the goal a little to its left or right, to where a car has the clearance, m; without such a place it stays.
  /// @return whether it has been moved
  bool moveAside(const Costmap & costmap, double clearance);

  void setNext(std::vector<Pose2> next) { next_ = std::move(next); }
  /// Whether another one follows: then the goal may be passed without a stop.
  bool anyNext() const { return !next_.empty(); }
  const std::vector<Pose2> & next() const { return next_; }
  /// Least way from the goal to the last one, m; HUGE_VAL when they lead back to the goal, again and again.
  double wayToLast() const;

private:
  std::optional<Pose2> goal_;
  Pose2 given_;  // where it was before it was moved
  std::vector<Pose2> next_;
};
}  // namespace f1tenth_racer
