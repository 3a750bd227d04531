#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/lidar/lidar_scene.h"
#include "core/lidar/range_raster.h"
#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_sim2d
{
/// One lidar of a car. Scanning allocates nothing: the space that it takes is the lidar's own, and one thread at a time has it.
class LidarSensor
{
public:
  /// @param scene  at the height of this lidar
  LidarSensor(const LidarDescription & description, const LidarScene & scene);

  /// @param car     pose of base_footprint
  /// @param ranges  beam_count values, m, as Simulation::exactScan() documents them
  void scan(CarId own, const Pose2 & car, const MovingPoses & poses, float * ranges) const;

  /// The same with the noise of a key.
  void noisyScan(CarId own, const Pose2 & car, const MovingPoses & poses, std::uint64_t key, float * ranges) const;

private:
  /// What a scan is made in.
  struct Space
  {
    Space(const LidarDescription & lidar, const LidarScene & scene);

    std::mutex mutex;
    RangeRaster raster;
    DrawnItems drawn;
    std::vector<double> normal;  ///< standard normal noise
  };

  void measure(Space & space, CarId own, const Pose2 & car, const MovingPoses & poses) const;

  LidarDescription description_;
  Pose2 mount_;
  const LidarScene * scene_;
  std::unique_ptr<Space> space_;
};
}  // namespace f1tenth_sim2d
