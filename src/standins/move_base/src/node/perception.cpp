#include "perception.h"

#include <ros/console.h>
#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "conversions.h"

namespace move_base
{
namespace
{
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();
constexpr std::size_t kMostWaiting = 10;  // scans
}  // namespace

Perception::Perception(ros::NodeHandle node, const MoveBaseParameters & parameters)
: parameters_(parameters),
  footprint_(parameters.footprint, parameters.footprint_padding),
  listener_(buffer_, node, false, kNoDelay)
{
  map_subscriber_ = node.subscribe(parameters.map_topic, 1, &Perception::onMap, this, kNoDelay);
  odometry_subscriber_ = node.subscribe(parameters.odom_topic, 10, &Perception::onOdometry, this, kNoDelay);
  scan_subscriber_ = node.subscribe(parameters.scan_topic, 2, &Perception::onScan, this, kNoDelay);
}

bool Perception::ready() const
{
  return missing().empty();
}

std::string Perception::missing() const
{
  if (!costmap_) {
    return "a map on " + map_subscriber_.getTopic();
  }
  if (!odometry_) {
    return "odometry on " + odometry_subscriber_.getTopic();
  }
  if (!scan_ && waiting_.empty()) {
    return "a scan on " + scan_subscriber_.getTopic();
  }
  return baseTransform() ? "" : "the transform from " + parameters_.global_frame + " to " + parameters_.base_frame;
}

CycleInput Perception::input(const ros::Time & now) const
{
  CycleInput input;
  input.time = now.toSec();
  input.sensors_current = stale(now).empty();
  if (const auto base = baseTransform()) {
    input.car.pose = fromTransform(base->transform);
    input.age = std::max(0.0, (now - base->header.stamp).toSec());
  }
  if (odometry_) {
    input.car.speed = odometry_->twist.twist.linear.x;
    input.car.yaw_rate = odometry_->twist.twist.angular.z;
    input.speed_age = std::max(0.0, (now - odometry_->header.stamp).toSec());
  }
  return input;
}

std::string Perception::stale(const ros::Time & now) const
{
  // What is far in the future was not measured by this clock, and would count as new for just as long.
  const auto old = [&](const ros::Time & stamp, double limit) { return std::abs((now - stamp).toSec()) > limit; };
  const auto base = baseTransform();
  if (!base || old(base->header.stamp, parameters_.transform_tolerance)) {
    return "the transform from " + parameters_.global_frame + " to " + parameters_.base_frame;
  }
  if (!odometry_ || old(odometry_->header.stamp, parameters_.sensor_timeout)) {
    return "the odometry on " + odometry_subscriber_.getTopic();
  }
  if (!scan_ || old(scan_->header.stamp, parameters_.sensor_timeout)) {
    return "the scan on " + scan_subscriber_.getTopic();
  }
  return "";
}

void Perception::updateCostmap(Navigator & navigator)
{
  if (!costmap_) {
    return;
  }
  auto rest = waiting_.begin();  // scans before one with a transform will no longer get theirs
  for (auto scan = waiting_.begin(); scan != waiting_.end(); ++scan) {
    const std_msgs::Header & header = (*scan)->header;
    if (const auto sensor = lookUp(buffer_, parameters_.global_frame, header.frame_id, header.stamp)) {
      navigator.observe(fromLaserScan(**scan, fromTransform(sensor->transform)), *costmap_);
      scan_ = *scan;
      rest = std::next(scan);
    }
  }
  waiting_.erase(waiting_.begin(), rest);
}

void Perception::startAgain()
{
  buffer_.clear();
  odometry_.reset();
  scan_.reset();
  waiting_.clear();
  if (costmap_) {
    costmap_->forgetAll();
  }
}

Pose2 Perception::poseIn(const std::string & target, const std::string & frame, const ros::Time & stamp) const
{
  return fromTransform(buffer_.lookupTransform(target, frame, stamp).transform);
}

Pose2 Perception::inMap(const geometry_msgs::PoseStamped & pose) const
{
  if (pose.header.frame_id == parameters_.global_frame) {
    return fromPose(pose.pose);
  }
  return compose(poseIn(parameters_.global_frame, pose.header.frame_id), fromPose(pose.pose));
}

void Perception::onMap(const nav_msgs::OccupancyGrid::ConstPtr & map)
{
  if (map->header.frame_id != parameters_.global_frame) {
    ROS_ERROR(
      "The map is in frame \"%s\", must be in global_costmap/global_frame \"%s\"; it is not used",
      map->header.frame_id.c_str(), parameters_.global_frame.c_str());
    return;
  }
  try {
    costmap_ = std::make_unique<Costmap>(fromUnturnedGrid(*map), parameters_.costmap, footprint_);
  } catch (const Error & error) {
    ROS_ERROR("%s; it is not used", error.what());
  }
}

void Perception::onScan(const sensor_msgs::LaserScan::ConstPtr & scan)
{
  waiting_.push_back(scan);
  // Odometry comes as often as scans or nearly so: what waits for longer will never get its transform.
  if (waiting_.size() > kMostWaiting) {
    waiting_.pop_front();
  }
}

std::optional<geometry_msgs::TransformStamped> Perception::baseTransform() const
{
  return lookUp(buffer_, parameters_.global_frame, parameters_.base_frame, ros::Time(0));
}
}  // namespace move_base
