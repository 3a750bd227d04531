#pragma once

#include <move_base/map/costmap.h>

#include <vector>

#include "path/terms.h"
#include "seen/obstacle_tracker.h"

namespace f1tenth_racer
{
/// Looks out for other cars: keeps what moves off the costmap, and gives what may be a standing car the outline of one.
class Lookout
{
public:
  /// Takes a scan into the costmap.
  void observe(const LaserScan & scan, Costmap & costmap);
  /// What moves; it does not count in the costmap's distances.
  const std::vector<MovingObstacle> & moving() const { return tracker_.moving(); }

private:
  ObstacleTracker tracker_;
};

/// The least distance from walls, m, on the next 1.2 m of an arc, 1/m.
double roomAlong(const Costmap & costmap, const Pose2 & from, double curvature);
}  // namespace f1tenth_racer
