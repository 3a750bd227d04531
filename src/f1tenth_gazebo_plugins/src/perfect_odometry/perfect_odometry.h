#pragma once

#include <f1tenth_sim2d/plugin.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>

#include <optional>

#include "odometry_parameters.h"

namespace f1tenth_gazebo_plugins
{
/// Publishes a car's exact pose and twist: nav_msgs/Odometry with the pose in odometryFrame, which is the world, and
/// the twist in robotBaseFrame, the link that represents the car; and, if it owns it, the transform between the two. On
/// poseTopic it publishes geometry_msgs/PoseStamped in the frame map, as f1tenth_simulator does.
class PerfectOdometry : public f1tenth_sim2d::CarPlugin
{
public:
  void load(const f1tenth_sim2d::PluginElement & element, const f1tenth_sim2d::CarPluginContext & context) override;
  double updateRate() const override { return parameters_.update_rate_hz; }
  void update(const ros::Time & stamp) override;

private:
  void measure(const ros::Time & stamp);
  void publishTransform();

  OdometryParameters parameters_;
  std::optional<f1tenth_sim2d::CarPluginContext> context_;
  ros::Publisher publisher_;
  std::optional<ros::Publisher> pose_publisher_;
  nav_msgs::Odometry odometry_;
  geometry_msgs::PoseStamped pose_;
  geometry_msgs::TransformStamped transform_;
};
}  // namespace f1tenth_gazebo_plugins
