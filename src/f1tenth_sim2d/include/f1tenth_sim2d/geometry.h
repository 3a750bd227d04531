#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <workspace_support/planar.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace f1tenth_sim2d
{
namespace maths = workspace_support::maths;
using workspace_support::Pose2;
using workspace_support::Vec2;

/// A convex polygon, counter-clockwise, at least three corners, without its closing corner; m.
using ConvexPolygon = std::vector<Vec2>;

/// A closed outline of any shape, counter-clockwise around solid matter, without its closing corner; m.
using Outline = std::vector<Vec2>;

/// Pose of a frame in another one: position, m, and rotation, a unit quaternion.
///
/// Turning about z alone leaves heights exact, and the identity leaves everything exact.
struct Pose3
{
  /// Not aligned: code that includes this header may be compiled for another vector unit than the simulator.
  using Rotation = Eigen::Quaternion<double, Eigen::DontAlign>;

  Eigen::Vector3d position{Eigen::Vector3d::Zero()};
  Rotation rotation{Rotation::Identity()};

  Pose3() = default;
  Pose3(const Eigen::Vector3d & place, const Rotation & turned) : position(place), rotation(turned) {}
  /// Angles in rad about the fixed axes: roll about x first, then pitch about y, then yaw about z.
  Pose3(double x, double y, double z, double roll, double pitch, double yaw)
  : position(x, y, z), rotation(rotationOf(roll, pitch, yaw))
  {
  }

  static Rotation rotationOf(double roll, double pitch, double yaw)
  {
    const double cos_roll = maths::cos(roll / 2.0);
    const double sin_roll = maths::sin(roll / 2.0);
    const double cos_pitch = maths::cos(pitch / 2.0);
    const double sin_pitch = maths::sin(pitch / 2.0);
    const double cos_yaw = maths::cos(yaw / 2.0);
    const double sin_yaw = maths::sin(yaw / 2.0);
    return Rotation(
             cos_roll * cos_pitch * cos_yaw + sin_roll * sin_pitch * sin_yaw,
             sin_roll * cos_pitch * cos_yaw - cos_roll * sin_pitch * sin_yaw,
             cos_roll * sin_pitch * cos_yaw + sin_roll * cos_pitch * sin_yaw,
             cos_roll * cos_pitch * sin_yaw - sin_roll * sin_pitch * cos_yaw)
      .normalized();
  }

  /// Heading seen from above, rad.
  double yaw() const
  {
    const Rotation & q = rotation;
    return maths::atan2(
      2.0 * (q.x() * q.y() + q.w() * q.z()), q.w() * q.w() + q.x() * q.x() - q.y() * q.y() - q.z() * q.z());
  }

  /// The z axis of this frame in the other one.
  Eigen::Vector3d up() const { return rotation * Eigen::Vector3d::UnitZ(); }
  /// The other frame's z axis in this one: its components tell how far each axis climbs.
  Eigen::Vector3d climb() const { return rotation.conjugate() * Eigen::Vector3d::UnitZ(); }

  Pose3 inverse() const { return {rotation.conjugate() * -position, rotation.conjugate()}; }
};

/// A point of the frame a, in the frame in which a is given.
inline Eigen::Vector3d operator*(const Pose3 & a, const Eigen::Vector3d & point)
{
  return a.position + a.rotation * point;
}

/// A pose b given in a, in the frame in which a is given.
inline Pose3 operator*(const Pose3 & a, const Pose3 & b)
{
  return {a * b.position, a.rotation * b.rotation};
}

inline bool operator==(const Pose3 & a, const Pose3 & b)
{
  return a.position == b.position && a.rotation.coeffs() == b.rotation.coeffs();
}
inline bool operator!=(const Pose3 & a, const Pose3 & b)
{
  return !(a == b);
}
}  // namespace f1tenth_sim2d
