#include "geometry/heights.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Heights kNone{kInfinity, -kInfinity};

Heights around(const Pose3 & pose, double half_height)
{
  return {pose.position.z() - half_height, pose.position.z() + half_height};
}

void include(double height, Heights & all)
{
  all = {std::min(all.lowest, height), std::max(all.highest, height)};
}

struct HeightsOf
{
  const Pose3 & pose;

  Heights operator()(const Box & box) const
  {
    const Vector3d up = pose.climb();
    const Vector3d half = 0.5 * box.size;
    return around(pose, std::abs(up.x()) * half.x() + std::abs(up.y()) * half.y() + std::abs(up.z()) * half.z());
  }
  Heights operator()(const Cylinder & cylinder) const
  {
    const Vector3d up = pose.climb();
    return around(pose, std::abs(up.z()) * cylinder.length / 2.0 + maths::hypot(up.x(), up.y()) * cylinder.radius);
  }
  Heights operator()(const Sphere & sphere) const { return around(pose, sphere.radius); }
  Heights operator()(const Capsule & capsule) const
  {
    return around(pose, std::abs(pose.climb().z()) * capsule.length / 2.0 + capsule.radius);
  }
  Heights operator()(const Ellipsoid & ellipsoid) const
  {
    return around(pose, pose.climb().cwiseProduct(ellipsoid.radii).norm());
  }
  Heights operator()(const Polyline & polyline) const
  {
    const Vector3d up = pose.climb();
    Heights all = kNone;
    for (const Outline & outline : polyline.outlines) {
      for (const Vec2 & corner : outline) {
        for (const double z : {0.0, polyline.height}) {
          include(pose.position.z() + up.x() * corner.x + up.y() * corner.y + up.z() * z, all);
        }
      }
    }
    return all;
  }
  Heights operator()(const Mesh & mesh) const
  {
    const Vector3d up = pose.climb();
    Heights all = kNone;
    for (const Vector3d & vertex : mesh.surface->vertices) {
      include(pose.position.z() + up.dot(vertex), all);
    }
    return all;
  }
  Heights operator()(const Plane &) const { return kNone; }
};
}  // namespace

Heights heightsOf(const Shape & shape, const Pose3 & pose)
{
  return std::visit(HeightsOf{pose}, shape);
}
}  // namespace f1tenth_sim2d
