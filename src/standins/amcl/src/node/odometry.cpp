#include "odometry.h"

#include <utility>

#include "conversions.h"

namespace amcl
{
Odometry::Odometry(std::string odom_frame, std::string base_frame)
: odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame))
{
}

std::optional<Pose2> Odometry::poseAt(const ros::Time & stamp) const
{
  if (!transforms_.canTransform(odom_frame_, base_frame_, stamp)) {
    return std::nullopt;
  }
  return fromTransform(transforms_.lookupTransform(odom_frame_, base_frame_, stamp).transform);
}

std::optional<ros::Time> Odometry::latest() const
{
  if (!transforms_.canTransform(odom_frame_, base_frame_, ros::Time(0))) {
    return std::nullopt;
  }
  return transforms_.lookupTransform(odom_frame_, base_frame_, ros::Time(0)).header.stamp;
}

std::optional<LidarMount> Odometry::mountOf(const std::string & lidar_frame) const
{
  const std::string frame = withoutSlash(lidar_frame);
  if (!transforms_.canTransform(base_frame_, frame, ros::Time(0))) {
    return std::nullopt;
  }
  const auto transform = transforms_.lookupTransform(base_frame_, frame, ros::Time(0)).transform;
  return LidarMount{fromTransform(transform), isUpsideDown(transform)};
}
}  // namespace amcl
