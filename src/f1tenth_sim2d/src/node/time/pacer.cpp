#include "node/time/pacer.h"

#include <cassert>

namespace f1tenth_sim2d
{
Pacer::Pacer(double factor) : factor_(factor)
{
  assert(factor > 0.0);
}

void Pacer::start(SimTime now, const ros::WallTime & wall_now)
{
  start_ = now;
  wall_start_ = wall_now;
}

ros::WallTime Pacer::due(SimTime time, const ros::WallTime & wall_now)
{
  const double elapsed_sec = static_cast<double>(time - start_) * 1e-9;
  const ros::WallTime due = wall_start_ + ros::WallDuration(elapsed_sec / factor_);
  if (wall_now - due <= ros::WallDuration(kMaxLag)) {
    return due;
  }
  start(time, wall_now);
  return wall_now;
}
}  // namespace f1tenth_sim2d
