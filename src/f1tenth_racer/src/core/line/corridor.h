#pragma once

#include <vector>

#include <move_base/map/costmap.h>
#include <move_base/path/path.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// Least clearance, m, of a car whose nose points off its motion by slip, rad, or does not yet: slip builds up slowly.
double clearanceWithSlip(const Costmap & costmap, const Pose2 & pose, double slip);

/// How far the car may be moved to either side of each point of the path, m, positive to the left of the car, so that
/// it keeps a clearance, m, or, where the path itself is nearer to obstacles, comes no nearer.
/// @param slips  rad, by which the nose points off the motion, of each point
std::vector<Interval> corridorAround(
  const Path & path, const Costmap & costmap, double clearance, const std::vector<double> & slips);
}  // namespace f1tenth_racer
