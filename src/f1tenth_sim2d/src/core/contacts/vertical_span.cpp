#include "core/contacts/vertical_span.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
using ignition::math::Pose3d;
using ignition::math::Vector3d;

constexpr double kLeastOverlap = 0.001;  // m
constexpr double kUprightTolerance = 1e-9;

/// The world's vertical in the frame of pose: its components say how far each axis climbs.
Vector3d climb(const Pose3d & pose)
{
  return pose.Rot().RotateVectorReverse(Vector3d::UnitZ);
}

VerticalSpan around(const Pose3d & pose, double half_height)
{
  return {pose.Pos().Z() - half_height, pose.Pos().Z() + half_height};
}

struct SpanOf
{
  const Pose3d & pose;

  VerticalSpan operator()(const Box & box) const
  {
    const Vector3d up = climb(pose);
    const Vector3d half = 0.5 * box.size;
    return around(pose, std::abs(up.X()) * half.X() + std::abs(up.Y()) * half.Y() + std::abs(up.Z()) * half.Z());
  }
  VerticalSpan operator()(const Cylinder & cylinder) const
  {
    const Vector3d up = climb(pose);
    return around(pose, std::abs(up.Z()) * cylinder.length / 2.0 + std::hypot(up.X(), up.Y()) * cylinder.radius);
  }
  VerticalSpan operator()(const Sphere & sphere) const { return around(pose, sphere.radius); }
  VerticalSpan operator()(const Polyline & polyline) const
  {
    const Vector3d up = climb(pose);
    VerticalSpan span{1.0, -1.0};
    for (const Vec2 & corner : polyline.outline) {
      for (const double z : {0.0, polyline.height}) {
        const double height = pose.Pos().Z() + up.X() * corner.x + up.Y() * corner.y + up.Z() * z;
        const bool first = span.bottom > span.top;
        span = {first ? height : std::min(span.bottom, height), first ? height : std::max(span.top, height)};
      }
    }
    return span;
  }
  VerticalSpan operator()(const WallPlan & walls) const
  {
    return walls.outlines.empty() ? VerticalSpan{1.0, -1.0}
                                  : around(pose * Pose3d(0, 0, walls.height / 2.0, 0, 0, 0), walls.height / 2.0);
  }
  VerticalSpan operator()(const Mesh & mesh) const
  {
    const Vector3d up = climb(pose);
    VerticalSpan span{1.0, -1.0};
    for (const Vector3d & vertex : mesh.surface->vertices) {
      const double height = pose.Pos().Z() + up.Dot(vertex);
      const bool first = span.bottom > span.top;
      span = {first ? height : std::min(span.bottom, height), first ? height : std::max(span.top, height)};
    }
    return span;
  }
  VerticalSpan operator()(const Plane &) const { return {1.0, -1.0}; }
};
}  // namespace

VerticalSpan verticalSpan(const Solid & solid, const Pose3d & pose)
{
  return std::visit(SpanOf{pose}, solid.shape);
}

bool overlap(const VerticalSpan & a, const VerticalSpan & b)
{
  return std::min(a.top, b.top) - std::max(a.bottom, b.bottom) > kLeastOverlap;
}

bool isUprightPrism(const Solid & solid, const Pose3d & pose)
{
  const Vector3d up = climb(pose);
  const bool is_prism = !std::holds_alternative<Sphere>(solid.shape) && !std::holds_alternative<Mesh>(solid.shape);
  return is_prism && std::hypot(up.X(), up.Y()) < kUprightTolerance;
}
}  // namespace f1tenth_sim2d
