#include "perfect_odometry.h"

#include <workspace_support/conversions.h>

#include <class_loader/class_loader.hpp>

namespace f1tenth_gazebo_plugins
{
namespace
{
constexpr const char * kLogger = ROSCONSOLE_DEFAULT_NAME ".perfect_odometry";

void setLogLevel(ros::console::levels::Level level)
{
  if (ros::console::set_logger_level(kLogger, level)) {
    ros::console::notifyLoggerLevelsChanged();
  }
}

/// Where a link of a car is in the world.
/// @param link  its pose in the frame of the car
geometry_msgs::Pose placed(const f1tenth_sim2d::Pose2 & car, const f1tenth_sim2d::Pose3 & link)
{
  const geometry_msgs::Quaternion turned = workspace_support::toPose(car).orientation;
  const f1tenth_sim2d::Pose3 pose =
    f1tenth_sim2d::Pose3({car.x, car.y, 0.0}, {turned.w, turned.x, turned.y, turned.z}) * link;
  return workspace_support::toPose(pose.position, pose.rotation);
}

/// The velocity of a link of a car, m/s along its own axes, as far as they are level.
f1tenth_sim2d::Vec2 velocityOf(const f1tenth_sim2d::CarState & car, const f1tenth_sim2d::Pose3 & link)
{
  const f1tenth_sim2d::Vec2 arm{link.position.x(), link.position.y()};
  return workspace_support::transform({0.0, 0.0, -link.yaw()}, velocityAt(car.velocity, car.yaw_rate, arm));
}
}  // namespace

void PerfectOdometry::load(
  const f1tenth_sim2d::PluginElement & element, const f1tenth_sim2d::CarPluginContext & context)
{
  const auto & simulation = context.simulation;
  const f1tenth_sim2d::CarDescription & car = simulation.car(context.car);
  parameters_ =
    parseOdometryParameters(element, car.links, car.base_frame, 1e9 / static_cast<double>(simulation.stepLength()));
  context_.emplace(context);
  if (parameters_.log_level) {
    setLogLevel(*parameters_.log_level);
  }
  odometry_.header.frame_id = context.frame_prefix + parameters_.odometry_frame;
  odometry_.child_frame_id = context.frame_prefix + car.base_frame;
  transform_.header.frame_id = odometry_.header.frame_id;
  transform_.child_frame_id = odometry_.child_frame_id;
  publisher_ = context.advertiser.advertise<nav_msgs::Odometry>(context.node, parameters_.topic);
  if (!parameters_.pose_topic.empty()) {
    pose_.header.frame_id = "map";
    pose_publisher_ = context.advertiser.advertise<geometry_msgs::PoseStamped>(context.node, parameters_.pose_topic);
  }
  ROS_INFO_NAMED(
    "perfect_odometry", "%s at %g Hz", context.node.resolveName(parameters_.topic).c_str(), parameters_.update_rate_hz);
}

void PerfectOdometry::update(const ros::Time & stamp)
{
  const bool subscribed = publisher_.getNumSubscribers() > 0;
  const bool poses = pose_publisher_ && pose_publisher_->getNumSubscribers() > 0;
  const bool transforms = context_->owns_odometry_transform && (parameters_.always_on || subscribed);
  if (subscribed || poses || transforms) {
    measure(stamp);
  }
  if (subscribed) {
    publisher_.publish(odometry_);
  }
  if (poses) {
    pose_.header.stamp = stamp;
    pose_.pose = odometry_.pose.pose;
    pose_publisher_->publish(pose_);
  }
  if (transforms) {
    publishTransform();
  }
}

void PerfectOdometry::measure(const ros::Time & stamp)
{
  const f1tenth_sim2d::CarState state = context_->simulation.state(context_->car);
  const f1tenth_sim2d::Pose3 & base = context_->simulation.car(context_->car).base_frame_pose;
  const f1tenth_sim2d::Vec2 velocity = velocityOf(state, base);
  odometry_.header.stamp = stamp;
  odometry_.pose.pose = placed(state.pose, base);
  odometry_.twist.twist.linear.x = velocity.x;
  odometry_.twist.twist.linear.y = velocity.y;
  odometry_.twist.twist.angular.z = state.yaw_rate;
}

void PerfectOdometry::publishTransform()
{
  transform_.header.stamp = odometry_.header.stamp;
  transform_.transform = workspace_support::toTransform(odometry_.pose.pose);
  context_->transforms.send(transform_);
}
}  // namespace f1tenth_gazebo_plugins

CLASS_LOADER_REGISTER_CLASS(f1tenth_gazebo_plugins::PerfectOdometry, f1tenth_sim2d::CarPlugin)
