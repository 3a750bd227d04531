#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/SetMap.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Empty.h>
#include <tf2/buffer_core.h>
#include <workspace_support/warnings.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "amcl/localizer.h"
#include "parameters.h"

namespace amcl
{
/// The ROS side of Localizer: scans wait for their transform, the results are published. Use from one thread.
class AmclNode
{
public:
  /// @param queue  of the services, initial poses and, with use_map_topic, maps
  AmclNode(const NodeParameters & parameters, ros::CallbackQueue & queue);

  /// To be filled by whoever receives transforms.
  tf2::BufferCore & transforms() { return transforms_; }
  /// Whether there is a map and a transform from it.
  bool ready() const { return map_to_odom_.has_value(); }

  void setMap(const nav_msgs::OccupancyGrid & map);
  void add(const sensor_msgs::LaserScan::ConstPtr & scan);
  /// Handles the scans whose transforms are there. Until the first one has told where the car is, the initial pose
  /// counts, so that the transform from the map is there from the start. A warning if there have been no map, no scans
  /// or no transform for them for 5 s of wall time.
  void handleScans();
  /// Forgets what was received before time jumped back; the map and the particles stay.
  void forgetInputs();

private:
  void setPose(const geometry_msgs::PoseWithCovarianceStamped & message);
  bool onSetMap(nav_msgs::SetMap::Request & request, nav_msgs::SetMap::Response & response);
  bool onGlobalLocalization(std_srvs::Empty::Request & request, std_srvs::Empty::Response & response);
  bool onUpdateWithoutMotion(std_srvs::Empty::Request & request, std_srvs::Empty::Response & response);

  /// @return whether the map is good; if not, the last one stays
  bool build(const nav_msgs::OccupancyGrid & map, const Estimate & start);
  /// @param estimate  where the car was at stamp
  void move(Estimate estimate, const ros::Time & stamp);
  /// Empty if nothing is.
  std::string missing() const;
  /// Which transform a scan lacks.
  std::string linkOf(const sensor_msgs::LaserScan & scan) const;
  void leaveOut(const sensor_msgs::LaserScan & scan, const std::string & reason);
  /// Transform of the car; time 0: the latest.
  std::optional<geometry_msgs::TransformStamped> odometryAt(const ros::Time & stamp) const;
  /// Whether there is later odometry than a scan that has none, so that none will come for it.
  bool isHopeless(const sensor_msgs::LaserScan & scan) const;
  void handle(const sensor_msgs::LaserScan & scan, const Pose2 & odometry, const geometry_msgs::Transform & lidar);
  void tell(Outcome outcome, const Pose2 & odometry, const ros::Time & stamp);
  void publishEstimate(const ros::Time & stamp);
  void publishParticles(const ros::Time & stamp);
  void broadcast(const std::vector<ros::Time> & stamps);
  void announceStart();
  void savePose(const ros::Time & now);

  NodeParameters parameters_;
  tf2::BufferCore transforms_;
  std::unique_ptr<Localizer> localizer_;
  Estimate estimate_;
  std::optional<Pose2> map_to_odom_;
  bool must_publish_{true};  // the next estimate, even if the particles are not resampled
  std::deque<sensor_msgs::LaserScan::ConstPtr> waiting_;
  bool hears_scans_{false};
  RareWarning left_out_warning_;
  WaitWarning wait_warning_;
  std::optional<ros::Time> last_saved_;
  ros::NodeHandle private_node_;
  ros::Publisher transform_publisher_;
  ros::Publisher pose_publisher_;
  ros::Publisher particle_publisher_;
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber pose_subscriber_;
  ros::Subscriber map_subscriber_;
};
}  // namespace amcl
