#pragma once

#include <array>
#include <ignition/math/Pose3.hh>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/vehicle_parameters.h"
#include "f1tenth_sim2d/world_model.h"

/// A car as the robot description gives it; frames of the car have no prefix here.
namespace f1tenth_sim2d
{
/// A planar lidar. Beam i points at angle_min + i * (angle_max - angle_min) / (beam_count - 1).
struct LidarDescription
{
  std::string name;
  std::string topic{"scan"};
  std::string frame{"laser"};
  ignition::math::Pose3d pose;  ///< in base_footprint; must be level
  double rate_hz{40.0};
  int beam_count{1081};
  double angle_min{0.0};     ///< rad
  double angle_max{0.0};     ///< rad
  double range_min{0.06};    ///< m
  double range_max{10.0};    ///< m
  double noise_mean{0.0};    ///< m
  double noise_stddev{0.0};  ///< m
};

/// A contact sensor: reports what touches the named collision elements.
struct BumperDescription
{
  std::string name;
  std::string topic;  ///< "bumper_front"
  std::string frame;
  double rate_hz{50.0};
  std::vector<std::string> collision_names;  ///< scoped names of Solids of the car
};

struct ImuDescription
{
  std::string name;
  std::string topic{"imu"};
  std::string frame{"imu"};
  double rate_hz{100.0};
  double yaw_rate_noise_stddev{0.0};      ///< rad/s
  double acceleration_noise_stddev{0.0};  ///< m/s^2
};

/// Names of the joints that joint_states carries. Wheels turn, steering joints follow Ackermann's geometry.
struct JointDescription
{
  std::string name;
  enum class Role
  {
    kWheelFrontLeft,
    kWheelFrontRight,
    kWheelRearLeft,
    kWheelRearRight,
    kSteeringLeft,
    kSteeringRight
  } role;
};

struct CarDescription
{
  std::string name;                ///< namespace of the car, "robot1"
  std::string source;              ///< where the description came from, for error messages
  std::vector<Solid> solids;       ///< in base_footprint, bumpers among them
  std::vector<std::string> links;  ///< all links of the robot description
  std::vector<LidarDescription> lidars;
  std::vector<BumperDescription> bumpers;
  std::optional<ImuDescription> imu;
  std::vector<JointDescription> joints;
  double joint_state_rate_hz{50.0};
  double wheel_radius{0.05};           ///< m
  double track_width{0.2};             ///< m, between the steering joints
  std::vector<PluginElement> plugins;  ///< not built in: to be looked up as shared libraries
  std::vector<std::string> warnings;
};
}  // namespace f1tenth_sim2d
