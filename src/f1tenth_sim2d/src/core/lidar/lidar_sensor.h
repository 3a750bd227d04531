#pragma once

#include <cstdint>
#include <vector>

#include "core/lidar/lidar_scene.h"
#include "core/lidar/range_raster.h"
#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_sim2d
{
/// One lidar of a car. Scanning allocates nothing.
class LidarSensor
{
public:
  /// @param scene  index of the scene at the height of this lidar
  LidarSensor(const LidarDescription & description, std::size_t scene);

  std::size_t scene() const { return scene_; }

  /// @param car    pose of base_footprint
  /// @param ranges  beam_count values, m, as Simulation::exactScan() documents them
  void scan(LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses, float * ranges);

  /// The same with the noise of a key.
  void noisyScan(
    LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses, std::uint64_t key,
    float * ranges);

private:
  void measure(LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses);

  LidarDescription description_;
  Pose2 mount_;
  std::size_t scene_;
  RangeRaster raster_;
  RangeLimits limits_;
  std::vector<double> normal_;  ///< standard normal noise of the scan in the making
};
}  // namespace f1tenth_sim2d
