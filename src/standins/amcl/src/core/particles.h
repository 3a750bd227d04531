#pragma once

#include <workspace_support/maths/random.h>

#include <vector>

#include "amcl/localizer_options.h"
#include "clusters.h"

namespace amcl
{
using Particles = std::vector<WeightedPose>;

/// Particles of equal weights.
Particles evenly(const std::vector<Pose2> & poses);

/// Poses of a normal distribution.
std::vector<Pose2> drawAround(const Estimate & estimate, std::size_t count, maths::Random & random);

/// Multiplies weights by likelihoods and brings their sum to 1.
/// @param logs  of the likelihoods, one per particle
void weigh(Particles & particles, const std::vector<double> & logs);

/// As many particles of equal weights, drawn by weight, as represent the belief (D. Fox: Adapting the Sample Size in
/// Particle Filters Through KLD-Sampling, International Journal of Robotics Research 22, 2003).
Particles resampled(const Particles & particles, const LocalizerOptions & options, maths::Random & random);
}  // namespace amcl
