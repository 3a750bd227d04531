#pragma once

#include <memory>
#include <vector>

#include "move_base/map/geometry.h"

namespace ompl::base
{
class DubinsStateSpace;
class ReedsSheppStateSpace;
}  // namespace ompl::base

namespace move_base
{
/// An arc of constant curvature.
struct Arc
{
  double length{0.0};     ///< m, negative when driven backwards
  double curvature{0.0};  ///< 1/m, positive is steering to the left
};

/// The shortest curves of bounded curvature between two poses: Dubins (forward only) or Reeds-Shepp, from OMPL.
class ShortestCurves
{
public:
  /// @param minimum_radius  m
  ShortestCurves(double minimum_radius, bool allow_reversing);

  /// Length of the shortest curve, m.
  double length(const Pose2 & from, const Pose2 & to) const;
  /// The shortest curve, arc by arc.
  std::vector<Arc> arcs(const Pose2 & from, const Pose2 & to) const;

private:
  double radius_;
  bool allow_reversing_;
  std::shared_ptr<ompl::base::DubinsStateSpace> dubins_;
  std::shared_ptr<ompl::base::ReedsSheppStateSpace> reeds_shepp_;
};
}  // namespace move_base
