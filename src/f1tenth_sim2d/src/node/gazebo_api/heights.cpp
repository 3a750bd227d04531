#include "node/gazebo_api/heights.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/errors.h"
#include "geometry/heights.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kLeastLift = 1e-3;  // m
constexpr double kLeastTilt = 1e-2;  // rad
constexpr double kDeepest = 0.5;     // m, below where a car stands: nobody means less than that

/// The heights that a model fills in the world, m.
Heights spanOf(const ModelDescription & model)
{
  Heights all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Solid & solid : model.solids) {
    const Heights heights = heightsOf(solid.shape, model.pose * solid.pose);
    all.lowest = std::min(all.lowest, heights.lowest);
    all.highest = std::max(all.highest, heights.highest);
  }
  return all;
}
}  // namespace

double liftOf(const ModelDescription & model, double z)
{
  const double lift = z - model.pose.position.z();
  if (std::abs(lift) < kLeastLift) {
    return 0.0;
  }
  const Heights heights = spanOf(model);
  const bool is_partly_below = heights.lowest + lift < 0.0 && heights.highest + lift > 0.0;
  const double out = is_partly_below && !model.is_static ? -heights.lowest : lift;
  return std::abs(out) < kLeastLift ? 0.0 : out;
}

void warnOfTilt(const Entity & model, const Pose3 & wanted)
{
  if ((withoutPlanar(model.pose).up() - withoutPlanar(wanted).up()).norm() > kLeastTilt) {
    ROS_WARN_ONCE(
      "SetModelState: %s keeps its roll and pitch, others are not simulated (said once)", model.name.c_str());
  }
}

void requireAboveGround(const Entity & car, const Pose3 & wanted)
{
  const double depth = car.pose.position.z() - wanted.position.z();
  if (depth > kDeepest) {
    throw Error(
      car.name + ": z is " + toText(wanted.position.z()) + " m, which is below the ground; a car stands on it");
  }
}
}  // namespace f1tenth_sim2d
