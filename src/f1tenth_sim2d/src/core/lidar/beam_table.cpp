#include "core/lidar/beam_table.h"

#include <cmath>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
double beamsPerRadian(const LidarDescription & lidar)
{
  return lidar.beam_count > 1 ? (lidar.beam_count - 1) / (lidar.angle_max - lidar.angle_min) : 1.0;
}
}  // namespace

BeamTable::BeamTable(const LidarDescription & lidar)
: angle_min(normalizeAngle(lidar.angle_min)),
  beams_per_radian(beamsPerRadian(lidar)),
  beams_per_turn(2.0 * M_PI * beams_per_radian)
{
  cosine.reserve(lidar.beam_count);
  sine.reserve(lidar.beam_count);
  for (int i = 0; i < lidar.beam_count; ++i) {
    const double angle = angle_min + i / beams_per_radian;
    const SineCosine at = sineCosine(angle);
    cosine.push_back(at.cosine);
    sine.push_back(at.sine);
  }
}
}  // namespace f1tenth_sim2d
