#pragma once

#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_sim2d
{
/// Directions of the beams of a lidar that stands upright, at equal angles, in its own frame.
struct Beams
{
  int count{1};
  double angle_min{0.0};  ///< rad, of the first
  double angle_max{0.0};  ///< rad, of the last

  double perRadian() const { return count > 1 ? (count - 1) / (angle_max - angle_min) : 1.0; }
};

inline bool operator==(const Beams & a, const Beams & b)
{
  return a.count == b.count && a.angle_min == b.angle_min && a.angle_max == b.angle_max;
}

inline bool isUpsideDown(const LidarDescription & lidar)
{
  return lidar.pose.up().z() < 0.0;
}

/// Those of a lidar; of one that is upside down in the opposite order.
inline Beams beamsOf(const LidarDescription & lidar)
{
  return isUpsideDown(lidar) ? Beams{lidar.beam_count, -lidar.angle_max, -lidar.angle_min}
                             : Beams{lidar.beam_count, lidar.angle_min, lidar.angle_max};
}
}  // namespace f1tenth_sim2d
