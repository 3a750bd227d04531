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
}  // namespace

void PerfectOdometry::load(
  const f1tenth_sim2d::PluginElement & element, const f1tenth_sim2d::CarPluginContext & context)
{
  const auto & simulation = context.simulation;
  parameters_ = parseOdometryParameters(
    element, simulation.car(context.car).links, 1e9 / static_cast<double>(simulation.stepLength()));
  context_.emplace(context);
  if (parameters_.log_level) {
    setLogLevel(*parameters_.log_level);
  }
  odometry_.header.frame_id = context.frame_prefix + parameters_.odometry_frame;
  odometry_.child_frame_id = context.frame_prefix + kRootLink;
  transform_.header.frame_id = odometry_.header.frame_id;
  transform_.child_frame_id = odometry_.child_frame_id;
  publisher_ = context.advertiser.advertise<nav_msgs::Odometry>(context.node, parameters_.topic);
  ROS_INFO_NAMED(
    "perfect_odometry", "%s at %g Hz", context.node.resolveName(parameters_.topic).c_str(), parameters_.update_rate_hz);
}

void PerfectOdometry::update(const ros::Time & stamp)
{
  const bool subscribed = publisher_.hasSubscribers();
  const auto & state = context_->simulation.state(context_->car);
  if (subscribed) {
    publishOdometry(stamp, state);
  }
  if (context_->owns_odometry_transform && (parameters_.always_on || subscribed)) {
    publishTransform(stamp, state);
  }
}

void PerfectOdometry::publishOdometry(const ros::Time & stamp, const f1tenth_sim2d::CarState & state)
{
  odometry_.header.stamp = stamp;
  odometry_.pose.pose = workspace_support::toPose(state.pose);
  odometry_.twist.twist.linear.x = state.velocity.x;
  odometry_.twist.twist.linear.y = state.velocity.y;
  odometry_.twist.twist.angular.z = state.yaw_rate;
  publisher_.publish(odometry_);
}

void PerfectOdometry::publishTransform(const ros::Time & stamp, const f1tenth_sim2d::CarState & state)
{
  transform_.header.stamp = stamp;
  transform_.transform = workspace_support::toTransform(state.pose);
  context_->transforms.send(transform_);
}
}  // namespace f1tenth_gazebo_plugins

CLASS_LOADER_REGISTER_CLASS(f1tenth_gazebo_plugins::PerfectOdometry, f1tenth_sim2d::CarPlugin)
