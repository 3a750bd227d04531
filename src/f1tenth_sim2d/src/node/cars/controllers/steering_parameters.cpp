#include "node/cars/controllers/steering_parameters.h"

#include <optional>
#include <vector>

#include "node/parameters/limits.h"

namespace f1tenth_sim2d
{
namespace
{
using workspace_support::atLeast;
using workspace_support::ParameterReader;
using workspace_support::positive;

/// @param axis      "linear/x"
/// @param quantity  "velocity"
std::optional<SpeedLimits::Range> readRange(
  ParameterReader & reader, const std::string & axis, const std::string & quantity)
{
  bool is_limited = false;
  double greatest = 0.0;
  reader.read(axis + "/has_" + quantity + "_limits", is_limited);
  const bool has_greatest = reader.read(axis + "/max_" + quantity, greatest, atLeast(0.0));
  double least = -greatest;
  reader.read(axis + "/min_" + quantity, least, {[](double value) { return value <= 0.0; }, " <= 0"});
  if (!is_limited) {
    return std::nullopt;
  }
  if (!has_greatest) {
    reader.fail(axis + "/max_" + quantity, "a number >= 0");
  }
  return SpeedLimits::Range{least, greatest};
}

SpeedLimits readLimits(ParameterReader & reader, const std::string & axis)
{
  return {
    readRange(reader, axis, "velocity"), readRange(reader, axis, "acceleration"), readRange(reader, axis, "jerk")};
}

/// Reads the diagonal: six variances.
SteeringParameters::Covariance readCovariance(
  const ros::NodeHandle & node, ParameterReader & reader, const std::string & name)
{
  constexpr std::size_t kRows = 6;
  SteeringParameters::Covariance covariance{};
  reader.ignore({name});
  std::vector<double> diagonal;
  if (node.hasParam(name) && (!node.getParam(name, diagonal) || diagonal.size() != kRows)) {
    reader.fail(name, "a list of six numbers");
  }
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    covariance[i * (kRows + 1)] = diagonal[i];
  }
  return covariance;
}
}  // namespace

SteeringParameters readSteeringParameters(const ControllerSetup & setup)
{
  ParameterReader reader = setup.parameters();
  SteeringParameters p;
  reader.read("rear_wheel", p.rear_wheel);
  reader.read("front_steer", p.front_steer);
  p.wheel_separation_h = setup.car.simulation.parameters(setup.car.id).wheelbase();
  p.wheel_radius = setup.car.description().wheel_radius;
  reader.read("wheel_separation_h", p.wheel_separation_h, positive());
  reader.read("wheel_radius", p.wheel_radius, positive());
  reader.read("wheel_separation_h_multiplier", p.wheel_separation_h_multiplier, positive());
  reader.read("wheel_radius_multiplier", p.wheel_radius_multiplier, positive());
  reader.read("steer_pos_multiplier", p.steer_pos_multiplier);
  reader.read("cmd_vel_timeout", p.cmd_vel_timeout, atLeast(0.0));
  p.linear = readLimits(reader, "linear/x");
  p.angular = readLimits(reader, "angular/z");
  reader.read("publish_rate", p.publish_rate, frequency());
  reader.read("odom_frame_id", p.odom_frame_id);
  reader.read("base_frame_id", p.base_frame_id);
  reader.read("enable_odom_tf", p.enable_odom_tf);
  reader.read("open_loop", p.open_loop);
  reader.read("velocity_rolling_window_size", p.velocity_rolling_window_size, atLeast(1.0));
  p.pose_covariance = readCovariance(setup.node(), reader, "pose_covariance_diagonal");
  p.twist_covariance = readCovariance(setup.node(), reader, "twist_covariance_diagonal");
  // The original's other parameters change nothing here.
  reader.ignore({"type", "allow_multiple_cmd_vel_publishers"});
  reader.warnOfUnused();
  return p;
}
}  // namespace f1tenth_sim2d
