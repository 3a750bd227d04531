#include "amcl_node.h"

#include <geometry_msgs/PoseArray.h>
#include <ros/console.h>
#include <ros/names.h>
#include <tf2_msgs/TFMessage.h>
#include <workspace_support/errors.h>
#include <workspace_support/lidar_inputs.h>

#include "conversions.h"

namespace amcl
{
namespace
{
constexpr std::size_t kLongestQueue = 100;  // scans, as the original's
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();
}  // namespace

AmclNode::AmclNode(const NodeParameters & parameters, ros::CallbackQueue & queue)
: parameters_(parameters), estimate_(parameters.start), private_node_("~")
{
  ros::NodeHandle node = servedBy(queue);
  pose_publisher_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>("amcl_pose", 2, true);
  particle_publisher_ = node.advertise<geometry_msgs::PoseArray>("particlecloud", 2, true);
  // Latched, unlike a tf2_ros::TransformBroadcaster: in lockstep's first period others wait for the transform.
  transform_publisher_ = node.advertise<tf2_msgs::TFMessage>("/tf", 100, true);
  services_ = {
    node.advertiseService("global_localization", &AmclNode::onGlobalLocalization, this),
    node.advertiseService("request_nomotion_update", &AmclNode::onUpdateWithoutMotion, this),
    node.advertiseService("set_map", &AmclNode::onSetMap, this)};
  pose_subscriber_ = node.subscribe("initialpose", 2, &AmclNode::setPose, this, kNoDelay);
  if (parameters.use_map_topic) {
    map_subscriber_ = node.subscribe("map", 1, &AmclNode::setMap, this, kNoDelay);
  }
}

void AmclNode::setMap(const nav_msgs::OccupancyGrid & map)
{
  if (localizer_ && parameters_.first_map_only) {
    return;
  }
  if (withoutSlash(map.header.frame_id) != parameters_.global_frame_id) {
    ROS_WARN(
      "The map is in frame \"%s\", global_frame_id is \"%s\"; it is used all the same", map.header.frame_id.c_str(),
      parameters_.global_frame_id.c_str());
  }
  build(map, estimate_);
}

bool AmclNode::build(const nav_msgs::OccupancyGrid & map, const Estimate & start)
{
  try {
    localizer_ = Localizer::make(fromOccupancyGrid(map), parameters_.localizer, start);
  } catch (const Error & error) {
    ROS_ERROR("%s; it is not used", error.what());
    return false;
  }
  estimate_ = start;
  must_publish_ = true;
  return true;
}

void AmclNode::setPose(const geometry_msgs::PoseWithCovarianceStamped & message)
{
  const std::string frame = withoutSlash(message.header.frame_id);
  if (!frame.empty() && frame != parameters_.global_frame_id) {
    ROS_WARN(
      "An initial pose is ignored: frame_id: found \"%s\", must be global_frame_id, \"%s\"", frame.c_str(),
      parameters_.global_frame_id.c_str());
    return;
  }
  try {
    move(fromPoseWithCovariance(message.pose), message.header.stamp);
  } catch (const Error & error) {
    ROS_WARN("An initial pose is ignored: %s", error.what());
  }
}

void AmclNode::move(Estimate estimate, const ros::Time & stamp)
{
  // The car has moved on since it was there.
  const auto then = odometryAt(stamp);
  const auto now = odometryAt(ros::Time(0));
  if (then && now) {
    const Pose2 motion = compose(inverse(fromTransform(then->transform)), fromTransform(now->transform));
    estimate.pose = compose(estimate.pose, motion);
  }
  estimate_ = estimate;
  if (localizer_) {
    localizer_->setPose(estimate);
    must_publish_ = true;
  }
}

void AmclNode::add(const sensor_msgs::LaserScan::ConstPtr & scan)
{
  hears_scans_ = true;
  if (waiting_.size() == kLongestQueue) {
    waiting_.pop_front();
  }
  waiting_.push_back(scan);
}

void AmclNode::handleScans()
{
  while (localizer_ && !waiting_.empty()) {
    const auto scan = waiting_.front();
    const auto odometry = odometryAt(scan->header.stamp);
    const auto lidar =
      lookUp(transforms_, parameters_.base_frame_id, withoutSlash(scan->header.frame_id), ros::Time(0));
    if (odometry && lidar) {
      handle(*scan, fromTransform(odometry->transform), lidar->transform);
    } else if (lidar && isHopeless(*scan)) {
      leaveOut(*scan, "there is no " + linkOf(*scan) + " for it");
    } else {
      break;
    }
    waiting_.pop_front();
    wait_warning_.reset();
  }
  announceStart();
  wait_warning_.waitFor(missing());
}

std::string AmclNode::missing() const
{
  if (!localizer_) {
    return "a map" + (parameters_.use_map_topic ? " on " + ros::names::resolve("map") : "");
  }
  if (!hears_scans_) {
    return "scans on " + ros::names::resolve("scan");
  }
  return waiting_.empty() ? "" : "a " + linkOf(*waiting_.front());
}

std::string AmclNode::linkOf(const sensor_msgs::LaserScan & scan) const
{
  const std::string & base = parameters_.base_frame_id;
  const std::string lidar = withoutSlash(scan.header.frame_id);
  const bool knows_lidar = lookUp(transforms_, base, lidar, ros::Time(0)).has_value();
  return knows_lidar ? "transform from " + parameters_.odom_frame_id + " to " + base
                     : "transform from " + base + " to " + lidar + ", the frame of the scans";
}

void AmclNode::leaveOut(const sensor_msgs::LaserScan & scan, const std::string & reason)
{
  left_out_warning_.say(scanIsLeftOut(scan.header.stamp, reason));
}

bool AmclNode::isHopeless(const sensor_msgs::LaserScan & scan) const
{
  const auto latest = odometryAt(ros::Time(0));
  return latest && latest->header.stamp > scan.header.stamp;
}

std::optional<geometry_msgs::TransformStamped> AmclNode::odometryAt(const ros::Time & stamp) const
{
  return lookUp(transforms_, parameters_.odom_frame_id, parameters_.base_frame_id, stamp);
}

void AmclNode::handle(
  const sensor_msgs::LaserScan & scan, const Pose2 & odometry, const geometry_msgs::Transform & lidar)
{
  try {
    const Scan seen = fromLaserScan(scan, isUpsideDown(lidar));
    tell(localizer_->process(seen, fromTransform(lidar), odometry), odometry, scan.header.stamp);
  } catch (const Error & error) {
    leaveOut(scan, error.what());
  }
}

void AmclNode::tell(Outcome outcome, const Pose2 & odometry, const ros::Time & stamp)
{
  if (outcome != Outcome::kIgnored) {
    publishParticles(stamp);
  }
  if (outcome == Outcome::kResampled || (outcome == Outcome::kUpdated && must_publish_)) {
    const Estimate estimate = localizer_->estimate();
    estimate.validate();  // odometry may have been anything
    must_publish_ = false;
    estimate_ = estimate;
    map_to_odom_ = compose(estimate_.pose, inverse(odometry));
    publishEstimate(stamp);
    savePose(stamp);
  }
  if (map_to_odom_) {
    broadcast({stamp + ros::Duration(parameters_.transform_tolerance)});
  }
}

void AmclNode::announceStart()
{
  const auto odometry = odometryAt(ros::Time(0));
  if (localizer_ && !map_to_odom_ && odometry) {
    const ros::Time & stamp = odometry->header.stamp;
    map_to_odom_ = compose(estimate_.pose, inverse(fromTransform(odometry->transform)));
    // From now on, not only from a later time on.
    broadcast({stamp, stamp + ros::Duration(parameters_.transform_tolerance)});
  }
}

void AmclNode::publishEstimate(const ros::Time & stamp)
{
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header = headerOf(parameters_.global_frame_id, stamp);
  message.pose = toPoseWithCovariance(estimate_);
  pose_publisher_.publish(message);
}

void AmclNode::publishParticles(const ros::Time & stamp)
{
  particle_publisher_.publish(toPoseArray(localizer_->particles(), headerOf(parameters_.global_frame_id, stamp)));
}

void AmclNode::broadcast(const std::vector<ros::Time> & stamps)
{
  if (!parameters_.tf_broadcast) {
    return;
  }
  tf2_msgs::TFMessage message;
  for (const ros::Time & stamp : stamps) {
    geometry_msgs::TransformStamped transform;
    transform.header = headerOf(parameters_.global_frame_id, stamp);
    transform.child_frame_id = parameters_.odom_frame_id;
    transform.transform = toTransform(*map_to_odom_);
    message.transforms.push_back(transform);
  }
  transform_publisher_.publish(message);
}

void AmclNode::savePose(const ros::Time & now)
{
  const bool rests =
    last_saved_ && now >= *last_saved_ && (now - *last_saved_).toSec() * parameters_.save_pose_rate < 1.0;
  if (parameters_.save_pose_rate <= 0.0 || rests) {
    return;
  }
  last_saved_ = now;
  private_node_.setParam("initial_pose_x", estimate_.pose.x);
  private_node_.setParam("initial_pose_y", estimate_.pose.y);
  private_node_.setParam("initial_pose_a", estimate_.pose.yaw);
  private_node_.setParam("initial_cov_xx", estimate_.covariance[0]);
  private_node_.setParam("initial_cov_yy", estimate_.covariance[4]);
  private_node_.setParam("initial_cov_aa", estimate_.covariance[8]);
}

void AmclNode::forgetInputs()
{
  transforms_.clear();
  waiting_.clear();
  last_saved_.reset();
}

bool AmclNode::onSetMap(nav_msgs::SetMap::Request & request, nav_msgs::SetMap::Response & response)
{
  response.success = false;
  try {
    response.success = build(request.map, fromPoseWithCovariance(request.initial_pose.pose));
  } catch (const Error & error) {
    ROS_WARN("A map and an initial pose are ignored: %s", error.what());
  }
  return true;
}

bool AmclNode::onGlobalLocalization(std_srvs::Empty::Request &, std_srvs::Empty::Response &)
{
  if (!localizer_) {
    ROS_WARN("There is no map yet to be anywhere on");
    return false;
  }
  try {
    localizer_->spreadOut();
    must_publish_ = true;
  } catch (const Error & error) {
    ROS_ERROR("%s", error.what());
    return false;
  }
  return true;
}

bool AmclNode::onUpdateWithoutMotion(std_srvs::Empty::Request &, std_srvs::Empty::Response &)
{
  if (localizer_) {
    localizer_->updateNext();
    must_publish_ = true;
  }
  return localizer_ != nullptr;
}
}  // namespace amcl
