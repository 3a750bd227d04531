#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_broadcaster.h>
#include <workspace_support/warnings.h>

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "gmapping/grid_slam.h"
#include "parameters.h"

namespace gmapping
{
/// The ROS side of GridSlam: scans wait for their transform, the results are published.
/// Use from one thread; broadcast() may be called from another one.
class SlamNode
{
public:
  /// @param queue  of the service
  SlamNode(const NodeParameters & parameters, ros::CallbackQueue & queue);

  /// The transforms that scans need; to be filled by whoever receives them.
  tf2::BufferCore & transforms() { return transforms_; }
  /// Whether there is a transform of the car from odometry.
  bool knowsOdometry() const
  {
    return transforms_.canTransform(parameters_.odom_frame, parameters_.base_frame, ros::Time(0));
  }
  /// Takes every throttle_scans-th scan.
  void add(const sensor_msgs::LaserScan::ConstPtr & scan);
  /// Handles the scans whose transforms are there. Leaves out, with a warning, those that can no longer get one, and
  /// those that make no sense.
  void handleScans();
  /// Warns if there have been no scans, or no transform for them, for 5 s of wall time.
  void sayWhatIsMissing();
  /// Keeps 1000 scans that wait: for a node that may run for ever.
  void leaveOutTheOldest();
  /// Leaves out all scans that wait: nothing more will come.
  void giveUpWaiting();
  /// Whether a scan has been handled, and not left out.
  bool hasTaken() const { return has_taken_; }
  /// Why the last scan that was left out was left out.
  const std::string & lastReason() const { return last_reason_; }
  /// Publishes map -> odom, if that is due at now. @param now  ROS time
  void broadcast(const ros::Time & now);
  /// Publishes the map as it is now, no matter when the last one was.
  void publishMap(const ros::Time & stamp);
  /// Forgets what was received before time jumped back; the map stays.
  void forgetInputs();

private:
  /// Transform of the lidar; time 0: the latest.
  std::optional<geometry_msgs::TransformStamped> odometryAt(
    const ros::Time & stamp, const sensor_msgs::LaserScan & scan) const;
  std::string linkOf(const sensor_msgs::LaserScan & scan) const;
  void leaveOut(const sensor_msgs::LaserScan & scan, const std::string & reason);
  bool isHopeless(const sensor_msgs::LaserScan & scan) const;
  void handle(const sensor_msgs::LaserScan & scan, const Pose2 & odometry);
  bool process(const sensor_msgs::LaserScan & scan, const Pose2 & odometry);
  bool isUpsideDown(const std::string & frame) const;
  bool onGetMap(nav_msgs::GetMap::Request & request, nav_msgs::GetMap::Response & response);

  NodeParameters parameters_;
  std::unique_ptr<GridSlam> slam_;
  tf2::BufferCore transforms_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher map_publisher_;
  ros::Publisher metadata_publisher_;
  ros::Publisher entropy_publisher_;
  ros::ServiceServer map_service_;
  std::deque<sensor_msgs::LaserScan::ConstPtr> waiting_;
  int scans_to_skip_{0};
  bool hears_scans_{false};
  bool has_taken_{false};
  std::string last_reason_;
  RareWarning left_out_warning_;
  WaitWarning wait_warning_;
  std::optional<ros::Time> last_map_;
  nav_msgs::OccupancyGrid map_;
  std::mutex broadcast_mutex_;  // of the two below
  Pose2 map_to_odom_;
  std::optional<ros::Time> last_broadcast_;
};
}  // namespace gmapping
