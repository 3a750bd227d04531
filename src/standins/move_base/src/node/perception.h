#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "move_base/control/navigator.h"
#include "parameters.h"

namespace move_base
{
/// What the car knows: its map, where it is, how fast, and what the lidar sees. All callbacks are on the queue of node.
class Perception
{
public:
  Perception(ros::NodeHandle node, const MoveBaseParameters & parameters);

  /// Whether map, odometry and scan have been received once, and the car's pose in the last seconds.
  bool ready() const;
  /// What is missing until ready, for a person to read.
  std::string missing() const;

  /// The car's state and whether everything is young enough at now to drive by.
  CycleInput input(const ros::Time & now) const;
  /// Why input() is stale, for a person to read; empty when it isn't.
  std::string stale(const ros::Time & now) const;

  /// Takes all scans into the costmap whose transforms are known; the others wait.
  void updateCostmap(Navigator & navigator);
  /// Forgets what was measured before time jumped back.
  void startAgain();

  Costmap & costmap() { return *costmap_; }
  const Costmap & costmap() const { return *costmap_; }

  /// A pose of another frame, by the latest transform. @throws tf2::TransformException
  Pose2 inMap(const geometry_msgs::PoseStamped & pose) const;
  /// Pose of frame in target; time 0: the latest. @throws tf2::TransformException
  Pose2 poseIn(const std::string & target, const std::string & frame, const ros::Time & stamp = {}) const;

private:
  void onMap(const nav_msgs::OccupancyGrid::ConstPtr & map);
  void onOdometry(const nav_msgs::Odometry::ConstPtr & odometry) { odometry_ = odometry; }
  void onScan(const sensor_msgs::LaserScan::ConstPtr & scan);
  std::optional<geometry_msgs::TransformStamped> baseTransform() const;

  const MoveBaseParameters & parameters_;
  Footprint footprint_;
  tf2::BufferCore buffer_;
  tf2_ros::TransformListener listener_;
  std::unique_ptr<Costmap> costmap_;
  nav_msgs::Odometry::ConstPtr odometry_;
  sensor_msgs::LaserScan::ConstPtr scan_;                 // the latest in the costmap
  std::deque<sensor_msgs::LaserScan::ConstPtr> waiting_;  // those not in the costmap yet
  ros::Subscriber map_subscriber_;
  ros::Subscriber odometry_subscriber_;
  ros::Subscriber scan_subscriber_;
};
}  // namespace move_base
