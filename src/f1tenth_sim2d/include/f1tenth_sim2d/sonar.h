#pragma once

#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// A sonar or infrared ranger: how far away the nearest thing is that one of its rays meets. libgazebo_ros_range.so.
struct SonarDescription : SensorDescription
{
  RayFan rays;                 ///< from where it is; range_max is that of the sonar
  double range_min{0.0};       ///< m
  double noise_stddev{0.0};    ///< m
  double field_of_view{0.05};  ///< rad, as it is published; the rays say what is seen
  bool is_infrared{false};
};
}  // namespace f1tenth_sim2d
