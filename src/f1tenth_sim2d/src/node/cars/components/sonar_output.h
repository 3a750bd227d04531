#pragma once

#include <sensor_msgs/Range.h>

#include "core/components/sonar/sonar.h"
#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
/// A sonar, as libgazebo_ros_range.so publishes it: max_range if it sees nothing.
class SonarOutput : public SensorOutput<Mount, sensor_msgs::Range>
{
public:
  SonarOutput(const CarHandle & car, const Sonar & sonar) : SensorOutput(car, sonar.mount()), sonar_(sonar)
  {
    const Sonar::Options & options = sonar.options();
    message_.radiation_type = options.is_infrared ? sensor_msgs::Range::INFRARED : sensor_msgs::Range::ULTRASOUND;
    message_.field_of_view = static_cast<float>(options.field_of_view);
    message_.min_range = static_cast<float>(options.range_min);
    message_.max_range = static_cast<float>(options.rays.range_max);
  }

private:
  void sample(sensor_msgs::Range & message) override
  {
    double range = 0.0;
    sonar_.sample(car_.simulation, car_.id, &range);
    message.range = static_cast<float>(range);
  }

  const Sonar & sonar_;
};
}  // namespace f1tenth_sim2d
