#pragma once

#include <mrpt/random/RandomGenerators.h>

#include <vector>

#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"
#include "scan_matcher.h"

namespace gmapping
{
/// What has been driven.
struct Progress
{
  double distance{0.0};  ///< m
  double turn{0.0};      ///< rad, to either side
};

/// Where a particle is after the lidar has moved by what odometry says.
/// @param motion    in the frame of the lidar before it
/// @param progress  way and turn of the motion, which may be longer than from its start to its end
PoseBelief expectedPose(const Pose2 & pose, const Pose2 & motion, const Progress & progress, const MotionNoise & noise);

/// A pose as likely as the belief says.
Pose2 drawPose(const PoseBelief & belief, mrpt::random::CRandomGenerator & random);

/// Weights that sum up to 1, from logarithms of likelihoods.
/// @param gain  each logarithm is divided by it first
std::vector<double> normalizedWeights(const std::vector<double> & log_weights, double gain);

/// How many equally good particles would be as good as these weights: 1 to their number.
double effectiveCount(const std::vector<double> & weights);

/// Entropy of the weights: 0 to log of their number.
double weightEntropy(const std::vector<double> & weights);

/// Index of the particle that each new particle is a copy of, in ascending order: systematic resampling.
std::vector<std::size_t> drawParticles(const std::vector<double> & weights, mrpt::random::CRandomGenerator & random);
}  // namespace gmapping
