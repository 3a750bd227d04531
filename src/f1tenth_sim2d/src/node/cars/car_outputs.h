#pragma once

#include <gazebo_msgs/ContactsState.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/JointState.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "node/cars/sensor_output.h"

/// What a car publishes besides its components. Frames and topics come from its description.
namespace f1tenth_sim2d
{
/// How wheel odometry is published: as a drive plugin of the description says, or on `odom`.
struct OdometryPlace
{
  std::string topic{"odom"};
  std::string frame{"odom"};
  std::string base_frame{"base_footprint"};
  Pose3 base_pose;  ///< of base_frame, in the frame of the car
  double rate_hz{50.0};
  bool has_topic{true};
  bool has_transform{true};
};
OdometryPlace odometryPlace(const CarDescription & car, const VehicleParameters & vehicle);

/// Wheel odometry.
class OdometryOutput : public MessageOutput<nav_msgs::Odometry>
{
public:
  OdometryOutput(CarHandle car, const OdometryPlace & place);

private:
  void fill(nav_msgs::Odometry & message, SimTime now) override;

  const CarHandle car_;
  const OdometryPlace place_;
};

/// Odometry frame -> base frame, from wheel odometry.
class OdometryTransformOutput : public Output
{
public:
  OdometryTransformOutput(CarHandle car, const OdometryPlace & place);
  double rate() const override { return place_.rate_hz; }
  void update(SimTime now, bool anyway) override;
  void repeat() override;

private:
  const CarHandle car_;
  const OdometryPlace place_;
  geometry_msgs::TransformStamped message_;
};

/// The true pose of a link: libgazebo_ros_p3d.so.
class PoseOutput : public SensorOutput<PoseSensorDescription, nav_msgs::Odometry>
{
public:
  PoseOutput(const CarHandle & car, const PoseSensorDescription & sensor);

private:
  void sample(nav_msgs::Odometry & message) override;
};

class JointStatesOutput : public MessageOutput<sensor_msgs::JointState>
{
public:
  JointStatesOutput(CarHandle car, const std::string & topic, double rate_hz, std::vector<JointDescription> joints);

private:
  void fill(sensor_msgs::JointState & message, SimTime now) override;

  const CarHandle car_;
  const std::vector<JointDescription> joints_;
};

/// A contact sensor. Each message carries what has touched since the one before, however short; of a pair of
/// collisions that touched more than once, the last touch.
class BumperOutput : public SensorOutput<BumperDescription, gazebo_msgs::ContactsState>
{
public:
  BumperOutput(const CarHandle & car, const BumperDescription & bumper);

  /// Contacts of other collisions are ignored.
  void note(const std::vector<Contact> & contacts) override;
  void restart() override { touches_.clear(); }

private:
  void sample(gazebo_msgs::ContactsState & message) override;
  void skip() override { touches_.clear(); }

  const std::set<std::string> collisions_;
  std::map<std::pair<std::string, std::string>, Contact> touches_;  // by own and other collision
};
}  // namespace f1tenth_sim2d
