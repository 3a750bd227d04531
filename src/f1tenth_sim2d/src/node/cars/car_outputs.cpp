#include "node/cars/car_outputs.h"

#include <algorithm>
#include <cmath>

#include "core/car/joint_state.h"
#include "node/messages/conversions.h"

namespace f1tenth_sim2d
{
namespace
{
// Height, roll and pitch of a car in the plane are known.
constexpr double kExact = 1e-9;

double square(double value)
{
  return value * value;
}

// Indices of the diagonal of a 6 x 6 covariance: x, y, z, roll, pitch, yaw.
void setPlanarVariances(boost::array<double, 36> & covariance, double x, double y, double yaw)
{
  covariance[0] = x;
  covariance[7] = y;
  covariance[14] = covariance[21] = covariance[28] = kExact;
  covariance[35] = yaw;
}

/// The link that a frame id means, which may have the car's name in front of it. end() if there is none.
auto linkOf(const CarDescription & car, const std::string & frame)
{
  const auto found = car.link_poses.find(frame);
  return found == car.link_poses.end() ? car.link_poses.find(withoutPrefix(frame, car.name + "/")) : found;
}
}  // namespace

OdometryPlace odometryPlace(const CarDescription & car, const VehicleParameters & vehicle)
{
  OdometryPlace place;
  place.base_frame = car.base_frame;
  place.base_pose = car.base_frame_pose;
  place.rate_hz = vehicle.odometry_rate_hz;
  // As in Gazebo, where controllers publish no odometry.
  place.has_topic = place.has_transform = !car.ros_control;
  if (car.drive) {
    place.topic = car.drive->odometry_topic;
    place.frame = car.drive->odometry_frame;
    place.base_frame = car.drive->base_frame;
    place.has_topic = car.drive->publishes_odometry;
    place.has_transform = car.drive->publishes_transform;
    if (const auto found = linkOf(car, place.base_frame); found != car.link_poses.end()) {
      place.base_pose = found->second;
    }
  }
  return place;
}

OdometryOutput::OdometryOutput(CarHandle car, const OdometryPlace & place)
: MessageOutput(car.advertise<nav_msgs::Odometry>(place.topic), place.rate_hz), car_(std::move(car)), place_(place)
{
  message_.header.frame_id = car_.frame(place_.frame);
  message_.child_frame_id = car_.frame(place_.base_frame);
}

void OdometryOutput::fill(nav_msgs::Odometry & message, SimTime now)
{
  const WheelOdometry odometry = car_.simulation.wheelOdometry(car_.id);
  const VehicleParameters & parameters = car_.simulation.parameters(car_.id);
  message.header.stamp = toRosTime(now);
  message.pose.pose = toPose(onGround(odometry.pose) * place_.base_pose);
  const Vec2 arm{place_.base_pose.position.x(), place_.base_pose.position.y()};
  const Vec2 velocity = velocityAt(Vec2{odometry.speed, odometry.lateral_speed}, odometry.yaw_rate, arm);
  message.twist.twist = toTwist(rotated(velocity, -place_.base_pose.yaw()), odometry.yaw_rate);
  // yaw_rate = speed * tan(steering) / wheelbase, to first order in the steering angle's noise
  const double turn = odometry.yaw_rate * parameters.wheelbase();
  const double speed = std::max(std::abs(odometry.speed), kExact);
  const double slope = (square(speed) + square(turn)) / (speed * parameters.wheelbase());
  setPlanarVariances(
    message.twist.covariance, square(parameters.odometry_speed_noise_stddev), kExact,
    square(slope * parameters.odometry_steering_noise_stddev));
}

OdometryTransformOutput::OdometryTransformOutput(CarHandle car, const OdometryPlace & place)
: car_(std::move(car)), place_(place)
{
  message_.header.frame_id = car_.frame(place_.frame);
  message_.child_frame_id = car_.frame(place_.base_frame);
}

void OdometryTransformOutput::update(SimTime now, bool /*anyway*/)
{
  message_.header.stamp = toRosTime(now);
  message_.transform = toTransformMessage(onGround(car_.simulation.wheelOdometry(car_.id).pose) * place_.base_pose);
  car_.transforms.send(message_);
}

void OdometryTransformOutput::repeat()
{
  if (!message_.header.stamp.isZero()) {
    car_.transforms.send(message_);
  }
}

PoseOutput::PoseOutput(const CarHandle & car, const PoseSensorDescription & sensor) : SensorOutput(car, sensor)
{
  message_.header.frame_id = sensor_.frame;
  message_.child_frame_id = car_.frame(sensor_.link);
  setPlanarVariances(message_.pose.covariance, kExact, kExact, kExact);
  const double variance = square(sensor_.noise_stddev) + kExact;
  setPlanarVariances(message_.twist.covariance, variance, variance, variance);
}

// As in the original: the twist is that of the link, in the frame of the world.
void PoseOutput::sample(nav_msgs::Odometry & message)
{
  const CarState & state = car_.simulation.state(car_.id);
  const Pose3 pose = onGround(state.pose) * sensor_.pose;
  const Eigen::Vector3d arm = pose.position - onGround(state.pose).position;
  const Vec2 velocity = rotated(state.velocity, state.pose.yaw);
  const Eigen::Vector3d & rpy = sensor_.rpy_offset;
  const Pose3::Rotation turned = Pose3::rotationOf(rpy.x(), rpy.y(), rpy.z());
  message.pose.pose = toPose(Pose3(pose.position + sensor_.xyz_offset, turned * pose.rotation));
  message.twist.twist = toTwist(velocityAt(velocity, state.yaw_rate, {arm.x(), arm.y()}), state.yaw_rate);
}

JointStatesOutput::JointStatesOutput(
  CarHandle car, const std::string & topic, double rate_hz, std::vector<JointDescription> joints)
: MessageOutput(car.advertise<sensor_msgs::JointState>(topic), rate_hz),
  car_(std::move(car)),
  joints_(std::move(joints))
{
  for (const auto & joint : joints_) {
    message_.name.push_back(joint.name);
  }
  message_.position.resize(joints_.size());
  message_.velocity.resize(joints_.size());
}

void JointStatesOutput::fill(sensor_msgs::JointState & message, SimTime now)
{
  message.header.stamp = toRosTime(now);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointState state = jointState(joints_[i], car_.simulation, car_.id);
    message.position[i] = state.position;
    message.velocity[i] = state.velocity;
  }
}

BumperOutput::BumperOutput(const CarHandle & car, const BumperDescription & bumper)
: SensorOutput(car, bumper), collisions_(bumper.collision_names.begin(), bumper.collision_names.end())
{
  // As in Gazebo, all vectors are in the world, whatever frame the sensor is in.
  message_.header.frame_id = "map";
}

void BumperOutput::note(const std::vector<Contact> & contacts)
{
  for (const Contact & contact : contacts) {
    if (collisions_.count(contact.own_collision) > 0) {
      touches_[{contact.own_collision, contact.other_collision}] = contact;
    }
  }
}

void BumperOutput::sample(gazebo_msgs::ContactsState & message)
{
  message.states.clear();
  for (const auto & [pair, contact] : touches_) {
    message.states.push_back(toContactState(contact));
  }
  touches_.clear();
}
}  // namespace f1tenth_sim2d
