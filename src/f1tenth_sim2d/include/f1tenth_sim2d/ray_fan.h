#pragma once

#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Level rays from a point of a car, in any directions.
struct RayFan
{
  Pose2 origin;                    ///< in the frame of the car
  double height{0.0};              ///< m, above the ground
  std::vector<double> directions;  ///< rad, from the heading of origin
  double range_max{0.0};           ///< m
};
}  // namespace f1tenth_sim2d
