#pragma once

#include <array>
#include <vector>

#include "amcl/geometry.h"
#include "amcl/localizer.h"

namespace amcl
{
struct WeightedPose
{
  Pose2 pose;
  double weight{0.0};
};

/// A cell of 0.5 m by 0.5 m by 10 degrees, in which particles are counted, as in the original.
using Bin = std::array<long, 3>;
Bin binOf(const Pose2 & pose);

/// Mean and covariance of the heaviest group of particles; groups are separated by empty cells. Needs a particle.
Estimate heaviestCluster(const std::vector<WeightedPose> & particles);
}  // namespace amcl
