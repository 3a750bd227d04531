#pragma once

#include <sensor_msgs/Range.h>

#include <vector>

#include "f1tenth_sim2d/sonar.h"
#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
/// A sonar, as libgazebo_ros_range.so publishes it: max_range if it sees nothing.
class SonarOutput : public SensorOutput<SonarDescription, sensor_msgs::Range>
{
public:
  SonarOutput(const CarHandle & car, const SonarDescription & sonar);

private:
  void sample(sensor_msgs::Range & message) override;

  std::vector<double> ranges_;
};
}  // namespace f1tenth_sim2d
