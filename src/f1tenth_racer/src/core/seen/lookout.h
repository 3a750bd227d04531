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
  /// What may be a standing car: all of it counts as occupied, however little of it the lidar sees.
  struct Standing
  {
    std::vector<Vec2> places;  ///< m, middles of cells
    Vec2 seen;                 ///< m, a point in it: when the lidar sees through it, all is gone
  };
  void hold(const Box & outline, const Vec2 & seen, const Costmap & costmap);
  void forgetIn(const Box & outline, Costmap & costmap);

  ObstacleTracker tracker_;
  std::vector<Standing> standing_;
};

/// The least distance from walls, m, on the next 1.2 m of an arc, 1/m.
double roomAlong(const Costmap & costmap, const Pose2 & from, double curvature);
}  // namespace f1tenth_racer
