#include "amcl/localizer_options.h"

#include <utility>
#include <vector>

#include "amcl/errors.h"

namespace amcl
{
namespace
{
template <class Model>
Model modelOf(
  const std::string & parameter, const std::string & name, const std::vector<std::pair<std::string, Model>> & models)
{
  std::string allowed;
  for (const auto & [known, model] : models) {
    if (name == known) {
      return model;
    }
    allowed += (allowed.empty() ? "" : ", ") + known;
  }
  throw OptionError(parameter + ": found \"" + name + "\", must be one of " + allowed);
}

void expect(bool valid, const std::string & name, double found, const std::string & allowed)
{
  if (!valid) {
    throw OptionError(name + ": found " + std::to_string(found) + ", must be " + allowed);
  }
}

void expectPositive(const std::string & name, double value)
{
  expect(std::isfinite(value) && value > 0.0, name, value, "above 0");
}

void expectNotNegative(const std::string & name, double value)
{
  expect(std::isfinite(value) && value >= 0.0, name, value, "0 or above");
}

void expectFinite(const std::string & name, double value)
{
  expect(std::isfinite(value), name, value, "a number");
}

void validateOdometry(const OdometryOptions & odometry)
{
  expectNotNegative("odom_alpha1", odometry.alpha1);
  expectNotNegative("odom_alpha2", odometry.alpha2);
  expectNotNegative("odom_alpha3", odometry.alpha3);
  expectNotNegative("odom_alpha4", odometry.alpha4);
  expectNotNegative("odom_alpha5", odometry.alpha5);
}

void validateLaser(const LaserOptions & laser)
{
  expect(laser.max_beams >= 2, "laser_max_beams", laser.max_beams, "2 or above");
  expectFinite("laser_min_range", laser.min_range);
  expectFinite("laser_max_range", laser.max_range);
  expectNotNegative("laser_z_hit", laser.z_hit);
  expectNotNegative("laser_z_rand", laser.z_rand);
  expectPositive("laser_sigma_hit", laser.sigma_hit);
  expectPositive("laser_likelihood_max_dist", laser.likelihood_max_dist);
}
}  // namespace

OdometryModel toOdometryModel(const std::string & name)
{
  return modelOf<OdometryModel>(
    "odom_model_type", name,
    {{"diff", OdometryModel::kDiff},
     {"omni", OdometryModel::kOmni},
     {"diff-corrected", OdometryModel::kDiffCorrected},
     {"omni-corrected", OdometryModel::kOmniCorrected}});
}

LaserModel toLaserModel(const std::string & name)
{
  return modelOf<LaserModel>(
    "laser_model_type", name,
    {{"beam", LaserModel::kBeam},
     {"likelihood_field", LaserModel::kLikelihoodField},
     {"likelihood_field_prob", LaserModel::kLikelihoodFieldProb}});
}

void LocalizerOptions::validate() const
{
  validateOdometry(odometry);
  validateLaser(laser);
  expectPositive("min_particles", min_particles);
  expect(
    max_particles >= min_particles, "max_particles", max_particles,
    "at least min_particles, which is " + std::to_string(min_particles));
  expectPositive("kld_err", kld_err);
  expectFinite("kld_z", kld_z);
  expectNotNegative("update_min_d", update_min_d);
  expectNotNegative("update_min_a", update_min_a);
  expectPositive("resample_interval", resample_interval);
}
}  // namespace amcl
