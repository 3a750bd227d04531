#pragma once

#include <string>
#include <vector>

namespace f1tenth_navigation_mgr
{
/// One pose for the car to reach.
struct Goal
{
  std::string frame_id{"map"};
  double x{0.0};  ///< m
  double y{0.0};  ///< m
  double z{0.0};  ///< m
  double qx{0.0};
  double qy{0.0};
  double qz{0.0};
  double qw{1.0};  ///< (qx, qy, qz, qw) is a unit quaternion

  /// rad, in (-pi, pi]
  double Yaw() const;
};

bool operator==(const Goal & a, const Goal & b);

using Goals = std::vector<Goal>;

/// A goal on the ground, facing yaw (rad).
Goal PlanarGoal(double x, double y, double yaw, const std::string & frame_id = "map");
}  // namespace f1tenth_navigation_mgr
