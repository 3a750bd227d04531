#pragma once

#include <vector>

#include "amcl/geometry.h"
#include "amcl/localizer.h"

namespace amcl
{
/// Size of the cells in which particles are counted, as in the original.
constexpr double kBinSize = 0.5;                   // m
constexpr double kBinAngle = 10.0 * M_PI / 180.0;  // rad

struct WeightedPose
{
  Pose2 pose;
  double weight{0.0};
};

/// Mean and covariance of the heaviest group of particles; groups are separated by empty cells. Needs a particle.
Estimate heaviestCluster(const std::vector<WeightedPose> & particles);
}  // namespace amcl
