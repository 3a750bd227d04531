#pragma once

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "f1tenth_sim2d/component.h"
#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"
#include "f1tenth_sim2d/world_model.h"

/// A car as its robot description defines it.
///
/// Poses are in the frame of the car: on the ground below the middle of the rear axle, x forwards, z upwards.
/// Frame ids of the car are those of its description. Topics without a leading slash are in the namespace of the car; a
/// <robotNamespace> of the description is already part of the topic ("/racecar/scan").
namespace f1tenth_sim2d
{
/// A planar lidar. Beam i points at angle_min + i * (angle_max - angle_min) / (beam_count - 1) about its own z axis.
struct LidarDescription
{
  std::string name;
  std::string topic{"scan"};
  std::string frame{"laser"};
  Pose3 pose;            ///< must be level; may be upside down
  double rate_hz{40.0};  ///< 0: at every physics step
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
  double rate_hz{50.0};                      ///< 0: at every physics step
  std::vector<std::string> collision_names;  ///< scoped names of Solids of the car
};

/// The true pose of a link as nav_msgs/Odometry: libgazebo_ros_p3d.so.
struct PoseSensorDescription
{
  std::string name;
  std::string topic;
  std::string frame{"world"};                           ///< header.frame_id; a frame of the world, so without prefix
  std::string link;                                     ///< child_frame_id
  Pose3 pose;                                           ///< of the link
  Eigen::Vector3d xyz_offset{Eigen::Vector3d::Zero()};  ///< m, added to the position in the world
  Eigen::Vector3d rpy_offset{Eigen::Vector3d::Zero()};  ///< rad, turns the orientation in the world
  double rate_hz{0.0};                                  ///< 0: at every physics step
  double noise_stddev{0.0};                             ///< m/s and rad/s, of the twist
};

/// A wheel or a steering joint. Wheels turn, steering joints follow Ackermann geometry.
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
    kSteeringRight,
    // In the middle of the car: the only wheel there, or part of a single-track model in the car, for its controller.
    kWheelFrontMiddle,
    kWheelRearMiddle,
    kSteeringMiddle
  } role;
  double direction{1.0};  ///< +1: the angle grows when the wheel rolls forwards or steers to the left; -1: falls
  double lower{-std::numeric_limits<double>::infinity()};        ///< rad
  double upper{std::numeric_limits<double>::infinity()};         ///< rad
  double velocity_max{std::numeric_limits<double>::infinity()};  ///< rad/s
  double effort_max{std::numeric_limits<double>::infinity()};    ///< N m

  /// Whether it is a steering joint.
  bool steers() const
  {
    return role == Role::kSteeringLeft || role == Role::kSteeringRight || role == Role::kSteeringMiddle;
  }
};

/// A plugin that drives the car by geometry_msgs/Twist and publishes its odometry.
struct DriveDescription
{
  enum class Kind
  {
    kAckermann,     ///< libgazebo_ros_ackermann_drive.so
    kDifferential,  ///< libgazebo_ros_diff_drive.so
    kSkidSteer,     ///< libgazebo_ros_skid_steer_drive.so
    kPlanarMove     ///< libgazebo_ros_planar_move.so
  } kind{Kind::kAckermann};
  std::string command_topic{"cmd_vel"};
  std::string odometry_topic{"odom"};
  std::string odometry_frame{"odom"};
  std::string base_frame{"base_footprint"};  ///< child of odometry_frame
  double odometry_rate_hz{100.0};            ///< 0: at every physics step
  bool publishes_odometry{true};
  bool publishes_transform{true};
  double acceleration_max{
    std::numeric_limits<double>::infinity()};  ///< m/s^2, of the wheels; besides the limit of the car's parameters
  double steering_max{0.6};  ///< rad, of an Ackermann drive; besides the limit of the car's parameters
  double speed_max{20.0};    ///< m/s, likewise
};

/// libgazebo_ros_control.so: the controllers of a controller_manager move wheels and steering joints.
struct RosControlDescription
{
  std::string ros_namespace;       ///< like topics: without a leading slash it is in the car's; empty: the car's itself
  double control_period_sec{0.0};  ///< 0: the physics step
};

/// A <plugin> element: its tags as written, so that a plugin reads its own parameters.
struct PluginElement
{
  std::string name;
  std::string filename;  ///< as written, "libf1tenth_perfect_odometry.so"
  std::string place;     ///< element path, for error messages
  std::vector<std::pair<std::string, std::string>>
    parameters;  ///< tag and text, in order; nested ones as "outer/inner"
};

struct CarDescription
{
  std::string name;                         ///< "robot1"
  std::string ros_namespace;                ///< its own, without slash at either end; usually its name; empty: the root
  std::string source;                       ///< where the description came from, for error messages
  std::vector<Solid> solids;                ///< bumpers among them
  std::vector<Visual> visuals;              ///< what cameras see of it
  std::vector<std::string> links;           ///< all links of the robot description
  std::map<std::string, Pose3> link_poses;  ///< of all links, joints at zero

  /// The link that represents the car: base_footprint, or else base_link, or else the root. Child of odom in tf.
  std::string base_frame{"base_footprint"};
  Pose3 base_frame_pose;
  Pose3 model_pose;  ///< of the model's own frame, which Gazebo's model states refer to
  Pose3 own_pose;    ///< of that frame, as its description gives it, relative to where Gazebo is told to spawn the car

  std::vector<LidarDescription> lidars;
  std::vector<BumperDescription> bumpers;
  std::vector<PoseSensorDescription> pose_sensors;
  std::vector<std::shared_ptr<const Component>> components;  ///< all others; a car gets clones of them
  std::optional<DriveDescription> drive;
  std::optional<RosControlDescription> ros_control;

  std::vector<JointDescription> mechanism;  ///< all wheels and steering joints
  std::vector<JointDescription> joints;     ///< the ones that joint_states carries
  std::string joint_state_topic{"joint_states"};
  double joint_state_rate_hz{50.0};    ///< 0: at every physics step
  double wheel_radius{0.05};           ///< m
  double track_width{0.2};             ///< m, between the steering joints
  VehicleParameters parameters;        ///< dynamics from the description; what it lacks is the F1/10 car's
  std::vector<PluginElement> plugins;  ///< not built in: to be looked up as shared libraries
  std::vector<std::string> warnings;

  /// The topic on which the car takes geometry_msgs/Twist; none for a car driven by controllers of ros_control only.
  std::optional<std::string> twistTopic() const
  {
    if (drive) {
      return drive->command_topic;
    }
    return ros_control ? std::nullopt : std::make_optional<std::string>("cmd_vel");
  }
};
}  // namespace f1tenth_sim2d
