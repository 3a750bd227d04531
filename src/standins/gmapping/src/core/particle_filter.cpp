#include "particle_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace gmapping
{
namespace
{
// Without any motion odometry is right to this, so that no standard deviation is 0.
constexpr double kLeastTranslation = 1e-4;  // m
constexpr double kLeastRotation = 1e-4;     // rad
// Sideways error of a translation over the error along it.
constexpr double kSideways = 0.3;
}  // namespace

PoseBelief expectedPose(const Pose2 & pose, const Pose2 & motion, const Progress & progress, const MotionNoise & noise)
{
  const double along = kLeastTranslation + noise.srr * progress.distance;
  const double aside = kLeastTranslation + kSideways * noise.srr * progress.distance + noise.str * progress.turn;
  const double rotation = kLeastRotation + noise.srt * progress.distance + noise.stt * progress.turn;
  const Eigen::Vector3d deviations(along, aside, rotation);
  // The errors are along and across the way, which bends by half the turn on average.
  const Eigen::Matrix3d turned =
    Eigen::AngleAxisd(pose.yaw + 0.5 * motion.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return {compose(pose, motion), turned * deviations.cwiseAbs2().cwiseInverse().asDiagonal() * turned.transpose()};
}

Pose2 drawPose(const PoseBelief & belief, mrpt::random::CRandomGenerator & random)
{
  Eigen::Vector3d normal;
  for (double & value : normal) {
    value = random.drawGaussian1D_normalized();
  }
  // With information = L L^T, the covariance of L^-T normal is its inverse.
  const Eigen::Vector3d offset = belief.information.llt().matrixU().solve(normal);
  return {belief.mean.x + offset.x(), belief.mean.y + offset.y(), normalizeAngle(belief.mean.yaw + offset.z())};
}

std::vector<double> normalizedWeights(const std::vector<double> & log_weights, double gain)
{
  const double best = *std::max_element(log_weights.begin(), log_weights.end());
  std::vector<double> weights(log_weights.size());
  std::transform(log_weights.begin(), log_weights.end(), weights.begin(), [&](double weight) {
    return std::exp((weight - best) / gain);
  });
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::for_each(weights.begin(), weights.end(), [&](double & weight) { weight /= sum; });
  return weights;
}

double effectiveCount(const std::vector<double> & weights)
{
  return 1.0 / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

double weightEntropy(const std::vector<double> & weights)
{
  return std::accumulate(weights.begin(), weights.end(), 0.0, [](double sum, double weight) {
    return weight > 0.0 ? sum - weight * std::log(weight) : sum;
  });
}

std::vector<std::size_t> drawParticles(const std::vector<double> & weights, mrpt::random::CRandomGenerator & random)
{
  const double step = 1.0 / static_cast<double>(weights.size());
  double target = random.drawUniform(0.0, step);
  double sum = 0.0;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i];
    for (; target < sum && chosen.size() < weights.size(); target += step) {
      chosen.push_back(i);
    }
  }
  // Rounding may leave the last one out.
  chosen.resize(weights.size(), chosen.empty() ? 0 : chosen.back());
  return chosen;
}
}  // namespace gmapping
