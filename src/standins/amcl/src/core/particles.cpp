#include "particles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace amcl
{
namespace
{
/// The lower triangle of a matrix whose product with its transpose this covariance is: Cholesky's.
std::array<double, 9> rootOf(const std::array<double, 9> & covariance)
{
  std::array<double, 9> root{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column <= row; ++column) {
      double rest = covariance[3 * row + column];
      for (int i = 0; i < column; ++i) {
        rest -= root[3 * row + i] * root[3 * column + i];
      }
      const double pivot = root[3 * column + column];
      root[3 * row + column] = row == column ? std::sqrt(std::max(rest, 0.0)) : pivot > 0.0 ? rest / pivot : 0.0;
    }
  }
  return root;
}

/// How many particles keep the error between true and estimated distribution below kld_err, in this many bins.
double particlesFor(std::size_t bins, const LocalizerOptions & options)
{
  if (bins < 2) {
    return options.min_particles;
  }
  const double freedom = static_cast<double>(bins) - 1.0;
  const double part = 2.0 / (9.0 * freedom);
  const double root = 1.0 - part + std::sqrt(part) * options.kld_z;
  return freedom / (2.0 * options.kld_err) * root * root * root;
}
}  // namespace

Particles evenly(const std::vector<Pose2> & poses)
{
  Particles particles;
  particles.reserve(poses.size());
  for (const Pose2 & pose : poses) {
    particles.push_back({pose, 1.0 / static_cast<double>(poses.size())});
  }
  return particles;
}

std::vector<Pose2> drawAround(const Estimate & estimate, std::size_t count, maths::Random & random)
{
  const std::array<double, 9> root = rootOf(estimate.covariance);
  std::vector<Pose2> poses;
  poses.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double a = random.gaussian();
    const double b = random.gaussian();
    const double c = random.gaussian();
    poses.push_back(
      {estimate.pose.x + root[0] * a, estimate.pose.y + root[3] * a + root[4] * b,
       normalizeAngle(estimate.pose.yaw + root[6] * a + root[7] * b + root[8] * c)});
  }
  return poses;
}

void weigh(Particles & particles, const std::vector<double> & logs)
{
  std::vector<double> products;
  products.reserve(logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) {
    products.push_back(logs[i] + maths::log(particles[i].weight));
  }
  const double greatest = *std::max_element(products.begin(), products.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < products.size(); ++i) {
    sum += particles[i].weight = maths::exp(products[i] - greatest);
  }
  for (WeightedPose & particle : particles) {
    particle.weight /= sum;
  }
}

Particles resampled(const Particles & particles, const LocalizerOptions & options, maths::Random & random)
{
  std::vector<double> sums;
  sums.reserve(particles.size());
  double sum = 0.0;
  for (const WeightedPose & particle : particles) {
    sums.push_back(sum += particle.weight);
  }
  const auto most = static_cast<std::size_t>(options.max_particles);
  const auto fewest = static_cast<std::size_t>(options.min_particles);
  std::vector<Pose2> drawn;
  std::set<Bin> bins;
  while (drawn.size() < most &&
         (drawn.size() < fewest || static_cast<double>(drawn.size()) < particlesFor(bins.size(), options))) {
    const auto found = std::upper_bound(sums.begin(), sums.end() - 1, random.uniform() * sum);
    drawn.push_back(particles[static_cast<std::size_t>(found - sums.begin())].pose);
    bins.insert(binOf(drawn.back()));
  }
  return evenly(drawn);
}
}  // namespace amcl
