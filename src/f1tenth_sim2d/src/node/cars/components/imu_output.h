#pragma once

#include <sensor_msgs/Imu.h>

#include "core/components/imu/imu.h"
#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
class ImuOutput : public SensorOutput<Mount, sensor_msgs::Imu>
{
public:
  ImuOutput(const CarHandle & car, const Imu & imu);

private:
  void sample(sensor_msgs::Imu & message) override;

  const Imu & imu_;
};
}  // namespace f1tenth_sim2d
