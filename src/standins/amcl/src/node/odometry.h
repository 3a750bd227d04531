#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "amcl/geometry.h"

namespace amcl
{
struct LidarMount
{
  Pose2 pose;  ///< on the car
  bool upside_down{false};
};

/// What the transforms say of the car: where odometry has it and where its lidar sits.
class Odometry
{
public:
  Odometry(std::string odom_frame, std::string base_frame);

  /// To be filled by whoever receives transforms.
  tf2::BufferCore & transforms() { return transforms_; }
  /// Pose of the car in the odometry's frame; time 0: the latest. Nothing if it is not known.
  std::optional<Pose2> poseAt(const ros::Time & stamp) const;
  /// Time of the latest pose.
  std::optional<ros::Time> latest() const;
  /// Nothing if there is no transform to the lidar.
  std::optional<LidarMount> mountOf(const std::string & lidar_frame) const;

private:
  std::string odom_frame_;
  std::string base_frame_;
  tf2::BufferCore transforms_;
};
}  // namespace amcl
