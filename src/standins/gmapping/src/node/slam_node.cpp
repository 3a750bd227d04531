#include "slam_node.h"

#include <ros/console.h>
#include <std_msgs/Float64.h>
#include <workspace_support/conversions.h>
#include <workspace_support/errors.h>
#include <workspace_support/lidar_inputs.h>

namespace gmapping
{
namespace
{
// What waits while the mapper is busy: closing a loop takes seconds on a long road, and more if time runs faster.
const ros::Duration kMemory{60.0};           // of transforms
constexpr std::size_t kLongestQueue = 2400;  // scans, a minute of them at 40 Hz
}  // namespace

SlamNode::SlamNode(const NodeParameters & parameters, ros::CallbackQueue & queue)
: parameters_(parameters), slam_(GridSlam::make(parameters.slam)), transforms_(kMemory)
{
  ros::NodeHandle node = servedBy(queue);
  map_publisher_ = node.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  metadata_publisher_ = node.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true);
  entropy_publisher_ = ros::NodeHandle("~").advertise<std_msgs::Float64>("entropy", 1, true);
  map_service_ = node.advertiseService("dynamic_map", &SlamNode::onGetMap, this);
}

void SlamNode::add(const sensor_msgs::LaserScan::ConstPtr & scan)
{
  hears_scans_ = true;
  if (scans_to_skip_ == 0) {
    waiting_.push_back(scan);
    scans_to_skip_ = parameters_.throttle_scans;
  }
  --scans_to_skip_;
}

void SlamNode::handleScans()
{
  while (!waiting_.empty()) {
    const auto scan = waiting_.front();
    const auto odometry = odometryAt(scan->header.stamp, *scan);
    if (odometry) {
      handle(*scan, fromTransform(odometry->transform));
    } else if (isHopeless(*scan)) {
      leaveOut(*scan, "there is no " + linkOf(*scan) + " for it");
    } else {
      return;
    }
    waiting_.pop_front();
    wait_warning_.reset();
  }
}

std::optional<geometry_msgs::TransformStamped> SlamNode::odometryAt(
  const ros::Time & stamp, const sensor_msgs::LaserScan & scan) const
{
  return lookUp(transforms_, parameters_.odom_frame, withoutSlash(scan.header.frame_id), stamp);
}

std::string SlamNode::linkOf(const sensor_msgs::LaserScan & scan) const
{
  return "transform from " + parameters_.odom_frame + " to " + withoutSlash(scan.header.frame_id);
}

void SlamNode::leaveOut(const sensor_msgs::LaserScan & scan, const std::string & reason)
{
  last_reason_ = reason;
  left_out_warning_.say(scanIsLeftOut(scan.header.stamp, reason));
}

void SlamNode::sayWhatIsMissing()
{
  if (!hears_scans_) {
    wait_warning_.waitFor("scans on " + ros::names::resolve("scan"));
  } else {
    wait_warning_.waitFor(waiting_.empty() ? "" : "a " + linkOf(*waiting_.front()) + ", the frame of the scans");
  }
}

void SlamNode::leaveOutTheOldest()
{
  for (; waiting_.size() > kLongestQueue; waiting_.pop_front()) {
    leaveOut(*waiting_.front(), "too many wait for their transform");
  }
}

void SlamNode::giveUpWaiting()
{
  if (!waiting_.empty()) {
    last_reason_ = "there is no " + linkOf(*waiting_.front());
    ROS_WARN("The last scans are left out, %zu: %s for them", waiting_.size(), last_reason_.c_str());
    waiting_.clear();
  }
}

// Whether the transforms are already past the scan.
bool SlamNode::isHopeless(const sensor_msgs::LaserScan & scan) const
{
  const auto latest = odometryAt(ros::Time(0), scan);
  return latest && latest->header.stamp > scan.header.stamp;
}

void SlamNode::handle(const sensor_msgs::LaserScan & scan, const Pose2 & odometry)
{
  if (!process(scan, odometry)) {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(broadcast_mutex_);
    map_to_odom_ = compose(slam_->pose(), inverse(odometry));
  }
  if (!last_map_ || scan.header.stamp - *last_map_ > ros::Duration(parameters_.map_update_interval)) {
    publishMap(scan.header.stamp);
  }
}

bool SlamNode::process(const sensor_msgs::LaserScan & scan, const Pose2 & odometry)
{
  try {
    const bool upside_down = isUpsideDown(withoutSlash(scan.header.frame_id));
    const bool counts = slam_->process(fromLaserScan(scan, upside_down), odometry, scan.header.stamp.toSec());
    has_taken_ = true;
    return counts;
  } catch (const Error & error) {
    leaveOut(scan, error.what());
    return false;
  }
}

bool SlamNode::isUpsideDown(const std::string & frame) const
{
  // Seen from the car: odometry says the same, but would have to be level.
  const auto lidar = lookUp(transforms_, parameters_.base_frame, frame, ros::Time(0));
  return lidar && workspace_support::isUpsideDown(lidar->transform);
}

void SlamNode::broadcast(const ros::Time & now)
{
  const std::lock_guard<std::mutex> lock(broadcast_mutex_);
  if (parameters_.transform_publish_period <= 0.0) {
    return;
  }
  // Half a millisecond early counts: a stamp is not a multiple of the period to the last bit.
  const ros::Duration period(parameters_.transform_publish_period - 0.0005);
  if (last_broadcast_ && now >= *last_broadcast_ && now - *last_broadcast_ < period) {
    return;
  }
  last_broadcast_ = now;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parameters_.map_frame;
  transform.header.stamp = now + ros::Duration(parameters_.tf_delay);
  transform.child_frame_id = parameters_.odom_frame;
  transform.transform = toTransform(map_to_odom_);
  broadcaster_.sendTransform(transform);
}

void SlamNode::publishMap(const ros::Time & stamp)
{
  map_ = toOccupancyGrid(slam_->map(), headerOf(parameters_.map_frame, stamp));
  map_.info.map_load_time = stamp;
  last_map_ = stamp;
  map_publisher_.publish(map_);
  metadata_publisher_.publish(map_.info);
  std_msgs::Float64 entropy;
  // Entropy of the weights of all hypotheses: there is only one.
  entropy.data = 0.0;
  entropy_publisher_.publish(entropy);
}

void SlamNode::forgetInputs()
{
  transforms_.clear();
  waiting_.clear();
  last_map_.reset();
}

bool SlamNode::onGetMap(nav_msgs::GetMap::Request &, nav_msgs::GetMap::Response & response)
{
  response.map = map_;
  return !map_.data.empty();
}
}  // namespace gmapping
