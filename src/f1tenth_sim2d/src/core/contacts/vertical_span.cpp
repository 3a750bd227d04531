#include "core/contacts/vertical_span.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

constexpr double kLeastOverlap = 0.001;  // m
constexpr double kUprightTolerance = 1e-9;

VerticalSpan around(const Pose3 & pose, double half_height)
{
  return {pose.position.z() - half_height, pose.position.z() + half_height};
}

void include(double height, VerticalSpan & span)
{
  const bool is_first = span.bottom > span.top;
  span = {is_first ? height : std::min(span.bottom, height), is_first ? height : std::max(span.top, height)};
}

struct SpanOf
{
  const Pose3 & pose;

  VerticalSpan operator()(const Box & box) const
  {
    const Vector3d up = pose.climb();
    const Vector3d half = 0.5 * box.size;
    return around(pose, std::abs(up.x()) * half.x() + std::abs(up.y()) * half.y() + std::abs(up.z()) * half.z());
  }
  VerticalSpan operator()(const Cylinder & cylinder) const
  {
    const Vector3d up = pose.climb();
    return around(pose, std::abs(up.z()) * cylinder.length / 2.0 + std::hypot(up.x(), up.y()) * cylinder.radius);
  }
  VerticalSpan operator()(const Sphere & sphere) const { return around(pose, sphere.radius); }
  VerticalSpan operator()(const Capsule & capsule) const
  {
    return around(pose, std::abs(pose.climb().z()) * capsule.length / 2.0 + capsule.radius);
  }
  VerticalSpan operator()(const Ellipsoid & ellipsoid) const
  {
    return around(pose, pose.climb().cwiseProduct(ellipsoid.radii).norm());
  }
  VerticalSpan operator()(const Polyline & polyline) const
  {
    const Vector3d up = pose.climb();
    VerticalSpan span{1.0, -1.0};
    for (const Outline & outline : polyline.outlines) {
      for (const Vec2 & corner : outline) {
        for (const double z : {0.0, polyline.height}) {
          include(pose.position.z() + up.x() * corner.x + up.y() * corner.y + up.z() * z, span);
        }
      }
    }
    return span;
  }
  VerticalSpan operator()(const Mesh & mesh) const
  {
    const Vector3d up = pose.climb();
    VerticalSpan span{1.0, -1.0};
    for (const Vector3d & vertex : mesh.surface->vertices) {
      include(pose.position.z() + up.dot(vertex), span);
    }
    return span;
  }
  VerticalSpan operator()(const Plane &) const { return {1.0, -1.0}; }
};
}  // namespace

VerticalSpan verticalSpan(const Solid & solid, const Pose3 & pose)
{
  return std::visit(SpanOf{pose}, solid.shape);
}

bool overlap(const VerticalSpan & a, const VerticalSpan & b)
{
  return std::min(a.top, b.top) - std::max(a.bottom, b.bottom) > kLeastOverlap;
}

bool isUprightPrism(const Solid & solid, const Pose3 & pose)
{
  const Vector3d up = pose.climb();
  const bool is_prism = std::holds_alternative<Box>(solid.shape) || std::holds_alternative<Cylinder>(solid.shape) ||
                        std::holds_alternative<Polyline>(solid.shape);
  return is_prism && std::hypot(up.x(), up.y()) < kUprightTolerance;
}
}  // namespace f1tenth_sim2d
