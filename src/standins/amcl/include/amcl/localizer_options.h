#pragma once

#include <cmath>
#include <cstdint>

namespace amcl
{
/// How odometry errs. The corrected models take the terms as variances, the other two as standard deviations, as
/// the original has always done.
enum class OdometryModel
{
  kDiff,
  kOmni,
  kDiffCorrected,
  kOmniCorrected
};

/// How a scan is compared with the map.
enum class LaserModel
{
  kBeam,                 ///< ranges compared with those that the map would give
  kLikelihoodField,      ///< distance of the beams' ends from the nearest wall, averaged over the beams
  kLikelihoodFieldProb,  ///< the same, multiplied: as if the beams were independent of each other
};

/// Odometry errs in proportion to what it measures.
struct OdometryOptions
{
  OdometryModel model{OdometryModel::kDiff};
  double alpha1{0.2};  ///< of rotation, by rotation
  double alpha2{0.2};  ///< of rotation, by translation
  double alpha3{0.2};  ///< of translation, by translation
  double alpha4{0.2};  ///< of translation, by rotation
  double alpha5{0.2};  ///< across the way, by translation; omni only
};

struct LaserOptions
{
  LaserModel model{LaserModel::kLikelihoodField};
  int max_beams{30};                ///< that are used, spread over the scan
  double min_range{-1.0};           ///< m, nearer beams do not count; negative: the lidar's
  double max_range{-1.0};           ///< m, farther beams do not count; negative: the lidar's
  double z_hit{0.95};               ///< weight of beams that end at a wall of the map
  double z_rand{0.05};              ///< weight of beams that end anywhere
  double sigma_hit{0.2};            ///< m, standard deviation of a beam's end from the wall
  double likelihood_max_dist{2.0};  ///< m, walls farther from a beam's end do not count
};

/// Options of Localizer. Names and defaults are those of amcl.
struct LocalizerOptions
{
  OdometryOptions odometry;
  LaserOptions laser;
  int min_particles{100};
  int max_particles{5000};
  double kld_err{0.01};             ///< greatest error between true and estimated distribution
  double kld_z{0.99};               ///< quantile of the normal distribution with which that error is kept
  double update_min_d{0.2};         ///< m between scans that count
  double update_min_a{M_PI / 6.0};  ///< rad between scans that count
  int resample_interval{2};         ///< scans that count until the particles are resampled
  std::uint32_t seed{0};            ///< of the particles
};
}  // namespace amcl
