#pragma once

#include <memory>
#include <vector>

#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"

namespace gmapping
{
/// Builds a map from scans and odometry: every 0.1 m a scan is matched to a map of the way just behind, and where the
/// lidar passes a place again, what it sees is matched to what it saw there before. The poses of the scans that count
/// are then moved to where all that agrees best (a pose graph). The same inputs give the same map.
class GridSlam
{
public:
  /// @throws OptionError
  static std::unique_ptr<GridSlam> make(const SlamOptions & options);
  virtual ~GridSlam() = default;

  /// Processes a scan. The first one is put into the map where odometry says; those after it count if they are far
  /// enough from the last that counted. Those between help to follow the lidar: all have to be given.
  /// @param odometry  pose of the lidar when it took the scan, according to odometry
  /// @param time      s, of the scan
  /// @return whether the scan counted
  /// @throws Error for a scan that does not say where its beams are, or for which the map would become too large; those
  /// after it are taken all the same
  virtual bool process(const Scan & scan, const Pose2 & odometry, double time) = 0;

  /// Pose of the lidar in the map as of the last scan that counted. Jumps when a loop is closed.
  virtual Pose2 pose() const = 0;
  /// Poses of the lidar at all scans that counted, as they are believed to be now.
  virtual const std::vector<Pose2> & path() const = 0;
  /// Takes longer after a loop was closed: then the map is rebuilt from all scans.
  /// @throws Error for a map that is too large
  virtual OccupancyGrid map() = 0;
};
}  // namespace gmapping
