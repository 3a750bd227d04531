#pragma once

#include <memory>

#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"

namespace gmapping
{
/// Builds a map from scans and odometry with a Rao-Blackwellized particle filter: each particle has a pose and a map of
/// its own; odometry moves it, matching the scan to its map corrects it, and how well that fits is its weight.
/// (G. Grisetti, C. Stachniss, W. Burgard: Improved Techniques for Grid Mapping with Rao-Blackwellized Particle
/// Filters, IEEE Transactions on Robotics 23, 2007.) The same inputs and the same seed give the same map.
class GridSlam
{
public:
  /// @throws OptionError
  explicit GridSlam(const SlamOptions & options);
  ~GridSlam();
  GridSlam(GridSlam &&) noexcept;
  GridSlam & operator=(GridSlam &&) noexcept;

  /// Takes a scan in. The first one is put into the map where odometry says; of those after it counts whatever lies
  /// far enough from the last that counted.
  /// @param odometry  pose of the lidar when it took the scan, as odometry knows it
  /// @param time      s, of the scan
  /// @return whether the scan counted
  bool process(const Scan & scan, const Pose2 & odometry, double time);

  /// Pose of the lidar in the map, of the best particle, as of the last scan that counted.
  Pose2 pose() const;
  /// Entropy of the weights of the particles: 0 if one is sure, log(particles) if all are equally good.
  double entropy() const;
  /// The map of the best particle. Needs a scan that counted.
  OccupancyGrid map() const;

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace gmapping
