#include "amcl/localizer_options.h"

#include <workspace_support/option_checks.h>

#include "amcl/geometry.h"

namespace amcl
{
namespace
{
void requireFinite(const std::string & name, double value)
{
  requireOption(std::isfinite(value), name, value, "a number");
}

void validateOdometry(const OdometryOptions & odometry)
{
  requireNotNegative("odom_alpha1", odometry.alpha1);
  requireNotNegative("odom_alpha2", odometry.alpha2);
  requireNotNegative("odom_alpha3", odometry.alpha3);
  requireNotNegative("odom_alpha4", odometry.alpha4);
  requireNotNegative("odom_alpha5", odometry.alpha5);
}

void validateLaser(const LaserOptions & laser)
{
  requireOption(laser.max_beams >= 2, "laser_max_beams", laser.max_beams, "2 or above");
  requireFinite("laser_min_range", laser.min_range);
  requireFinite("laser_max_range", laser.max_range);
  requireNotNegative("laser_z_hit", laser.z_hit);
  requireNotNegative("laser_z_rand", laser.z_rand);
  requirePositive("laser_sigma_hit", laser.sigma_hit);
  requirePositive("laser_likelihood_max_dist", laser.likelihood_max_dist);
}
}  // namespace

void LocalizerOptions::validate() const
{
  validateOdometry(odometry);
  validateLaser(laser);
  requirePositive("min_particles", min_particles);
  requireOption(
    max_particles >= min_particles, "max_particles", max_particles,
    "at least min_particles, which is " + std::to_string(min_particles));
  requirePositive("kld_err", kld_err);
  requireFinite("kld_z", kld_z);
  requireNotNegative("update_min_d", update_min_d);
  requireNotNegative("update_min_a", update_min_a);
  requirePositive("resample_interval", resample_interval);
}
}  // namespace amcl
