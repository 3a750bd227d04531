#pragma once

#include <cstdint>
#include <optional>

#include "core/lidar/lidar_scene.h"
#include "core/lidar/scan_space.h"
#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_sim2d
{
/// One lidar of a car.
class LidarSensor
{
public:
  /// @param scene  at the height of this lidar
  LidarSensor(const LidarDescription & description, const LidarScene & scene);

  /// @param car        pose of base_footprint
  /// @param noise_key  of the noise, if there is to be any
  /// @param ranges     beam_count values, m, as Simulation::exactScan() documents them
  void scan(
    CarId own, const Pose2 & car, const MovingPoses & poses, std::optional<std::uint64_t> noise_key,
    float * ranges) const;

private:
  LidarDescription description_;
  bool is_upside_down_;
  Pose2 mount_;
  const LidarScene * scene_;
  ScanSpaces * spaces_;
};
}  // namespace f1tenth_sim2d
