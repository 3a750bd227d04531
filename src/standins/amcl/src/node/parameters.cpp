#include "parameters.h"

#include <ros/console.h>
#include <workspace_support/conversions.h>
#include <workspace_support/errors.h>
#include <workspace_support/parameter_reader.h>

#include <cmath>

namespace amcl
{
namespace
{
// Those of the original that are not zero: (0.5 m)^2, (0.5 m)^2, (pi/12)^2.
constexpr double kStartVariance = 0.5 * 0.5;                         // m^2
constexpr double kStartYawVariance = (M_PI / 12.0) * (M_PI / 12.0);  // rad^2

void readFrames(ParameterReader & reader, NodeParameters & parameters)
{
  const auto read = [&reader](const std::string & name, std::string & frame) {
    reader.read(name, frame);
    frame = withoutSlash(frame);
  };
  read("base_frame_id", parameters.base_frame_id);
  read("odom_frame_id", parameters.odom_frame_id);
  read("global_frame_id", parameters.global_frame_id);
}

void readNode(ParameterReader & reader, NodeParameters & parameters)
{
  reader.read("use_map_topic", parameters.use_map_topic);
  reader.read("first_map_only", parameters.first_map_only);
  reader.read("tf_broadcast", parameters.tf_broadcast);
  reader.read("transform_tolerance", parameters.transform_tolerance, duration());
  reader.read("save_pose_rate", parameters.save_pose_rate);
  reader.read("lockstep", parameters.lockstep);
}

/// What is not a number is left out with a warning, as in the original.
Estimate readStart(const ros::NodeHandle & node, ParameterReader & reader)
{
  const auto read = [&](const std::string & name, double & value, const NumberRule & rule = {}) {
    try {
      reader.read(name, value, rule);
    } catch (const OptionError & error) {
      double given = 0.0;
      if (!node.getParam(name, given) || !std::isnan(given)) {
        throw;
      }
      ROS_WARN("%s; %g is used", error.what(), value);
    }
  };
  Estimate start;
  read("initial_pose_x", start.pose.x);
  read("initial_pose_y", start.pose.y);
  read("initial_pose_a", start.pose.yaw);
  start.covariance[0] = start.covariance[4] = kStartVariance;
  start.covariance[8] = kStartYawVariance;
  read("initial_cov_xx", start.covariance[0], atLeast(0.0));
  read("initial_cov_yy", start.covariance[4], atLeast(0.0));
  read("initial_cov_aa", start.covariance[8], atLeast(0.0));
  return start;
}

void readOdometry(ParameterReader & reader, OdometryOptions & odometry)
{
  reader.readChoice(
    "odom_model_type", odometry.model,
    {{"diff", OdometryModel::kDiff},
     {"omni", OdometryModel::kOmni},
     {"diff-corrected", OdometryModel::kDiffCorrected},
     {"omni-corrected", OdometryModel::kOmniCorrected}});
  reader.read("odom_alpha1", odometry.alpha1, atLeast(0.0));
  reader.read("odom_alpha2", odometry.alpha2, atLeast(0.0));
  reader.read("odom_alpha3", odometry.alpha3, atLeast(0.0));
  reader.read("odom_alpha4", odometry.alpha4, atLeast(0.0));
  reader.read("odom_alpha5", odometry.alpha5, atLeast(0.0));
}

void readLaser(ParameterReader & reader, LaserOptions & laser)
{
  reader.readChoice(
    "laser_model_type", laser.model,
    {{"beam", LaserModel::kBeam},
     {"likelihood_field", LaserModel::kLikelihoodField},
     {"likelihood_field_prob", LaserModel::kLikelihoodFieldProb}});
  reader.read("laser_max_beams", laser.max_beams, atLeast(2));
  reader.read("laser_min_range", laser.min_range);
  reader.read("laser_max_range", laser.max_range);
  reader.read("laser_z_hit", laser.z_hit, atLeast(0.0));
  reader.read("laser_z_rand", laser.z_rand, atLeast(0.0));
  reader.read("laser_sigma_hit", laser.sigma_hit, positive());
  reader.read("laser_likelihood_max_dist", laser.likelihood_max_dist, positive());
}

void readFilter(ParameterReader & reader, LocalizerOptions & localizer)
{
  reader.read("min_particles", localizer.min_particles, atLeast(1));
  reader.read("max_particles", localizer.max_particles);
  if (localizer.max_particles < localizer.min_particles) {
    ROS_WARN("max_particles is set to min_particles, which is %d, as it was below that", localizer.min_particles);
    localizer.max_particles = localizer.min_particles;
  }
  reader.read("kld_err", localizer.kld_err, positive());
  reader.read("kld_z", localizer.kld_z, within(0.0, 8.0));
  reader.read("update_min_d", localizer.update_min_d, atLeast(0.0));
  reader.read("update_min_a", localizer.update_min_a, atLeast(0.0));
  reader.read("resample_interval", localizer.resample_interval, atLeast(1));
  int seed = 0;
  reader.read("seed", seed);
  localizer.seed = static_cast<std::uint32_t>(seed);
}
}  // namespace

NodeParameters readParameters(const ros::NodeHandle & node)
{
  ParameterReader reader(node);
  NodeParameters parameters;
  readFrames(reader, parameters);
  readNode(reader, parameters);
  parameters.start = readStart(node, reader);
  readOdometry(reader, parameters.localizer.odometry);
  readLaser(reader, parameters.localizer.laser);
  readFilter(reader, parameters.localizer);
  reader.warnOfUnused();
  return parameters;
}
}  // namespace amcl
