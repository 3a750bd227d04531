#pragma once

#include <sensor_msgs/LaserScan.h>

#include <algorithm>

#include "core/components/lidar/lidar.h"
#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
class ScanOutput : public SensorOutput<LidarDescription, sensor_msgs::LaserScan>
{
public:
  ScanOutput(const CarHandle & car, const Lidar & lidar) : SensorOutput(car, lidar.description()), index_(lidar.index())
  {
    message_.angle_min = static_cast<float>(sensor_.angle_min);
    message_.angle_max = static_cast<float>(sensor_.angle_max);
    const int gaps = std::max(1, sensor_.beam_count - 1);
    message_.angle_increment = static_cast<float>((sensor_.angle_max - sensor_.angle_min) / gaps);
    message_.scan_time =
      static_cast<float>(sensor_.rate_hz > 0.0 ? 1.0 / sensor_.rate_hz : toSeconds(car.simulation.stepLength()));
    message_.range_min = static_cast<float>(sensor_.range_min);
    message_.range_max = static_cast<float>(sensor_.range_max);
    message_.ranges.resize(static_cast<std::size_t>(sensor_.beam_count));
  }
  bool isAnswered() const override { return true; }

private:
  void sample(sensor_msgs::LaserScan & message) override
  {
    car_.simulation.scan(car_.id, index_, message.ranges.data());
  }

  const std::size_t index_;
};
}  // namespace f1tenth_sim2d
