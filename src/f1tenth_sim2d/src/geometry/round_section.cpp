#include "geometry/round_section.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

#include "geometry/convex_body.h"
#include "geometry/heights.h"
#include "geometry/planar.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

/// A cylinder whose axis leans less is upright, its sides off by less than a micrometre per metre of height.
constexpr double kUprightSine = 1e-6;
constexpr double kGrid = 1e-12;  // m

bool standsUpright(const Pose3 & pose)
{
  const Vector3d up = pose.up();
  return maths::hypot(up.x(), up.y()) < kUprightSine;
}

std::vector<Vec2> pointsOn(const Circle & circle)
{
  const int steps = 4 * curveSteps(M_PI / 2.0, circle.radius);  // the outermost points are among them
  std::vector<Vec2> points;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2.0 * M_PI * i / steps;
    points.push_back(
      {circle.centre.x + circle.radius * maths::cos(angle), circle.centre.y + circle.radius * maths::sin(angle)});
  }
  return points;
}

/// A leaning cylinder, but for its curved side, which becomes flat faces.
ConvexBody bodyOf(const Cylinder & cylinder, const Pose3 & pose)
{
  return prism(pointsOn({{0.0, 0.0}, cylinder.radius}), -cylinder.length / 2.0, cylinder.length / 2.0, pose);
}

// Points that lie on a line but for rounding lose corners in Boost 1.83.
double withoutRounding(double coordinate)
{
  return std::round(coordinate / kGrid) * kGrid;
}

Section ofPoints(std::vector<Vec2> points)
{
  for (Vec2 & point : points) {
    point = {withoutRounding(point.x), withoutRounding(point.y)};
  }
  ConvexPolygon hull = convexHull(points);
  return hull.empty() ? Section{} : Section{{std::move(hull)}, {}};
}

Section ofCircle(const Vector3d & centre, double radius)
{
  return radius > kTolerance ? Section{{}, {{{centre.x(), centre.y()}, radius}}} : Section{};
}

double radiusAt(const Sphere & sphere, double height_over_centre)
{
  return std::sqrt(std::max(0.0, sphere.radius * sphere.radius - height_over_centre * height_over_centre));
}

/// The union of parts that together are convex; circles with the same centre stay a circle.
Section joined(const std::vector<Section> & parts, const Vector3d & middle)
{
  std::vector<Vec2> points;
  double radius = 0.0;
  bool only_circles = true;
  for (const Section & part : parts) {
    for (const Circle & circle : part.circles) {
      const std::vector<Vec2> around = pointsOn(circle);
      points.insert(points.end(), around.begin(), around.end());
      radius = std::max(radius, circle.radius);
      only_circles =
        only_circles && maths::hypot(circle.centre.x - middle.x(), circle.centre.y - middle.y()) < kTolerance;
    }
    for (const Outline & outline : part.outlines) {
      points.insert(points.end(), outline.begin(), outline.end());
      only_circles = false;
    }
  }
  return only_circles ? ofCircle(middle, radius) : ofPoints(points);
}

/// Applies cut or shadow to the cylinder and both spheres of a capsule.
template <typename Operation>
Section ofParts(const Capsule & capsule, const Pose3 & pose, Operation operation)
{
  const Vector3d half = pose.rotation * Vector3d(0.0, 0.0, capsule.length / 2.0);
  const Sphere end{capsule.radius};
  return joined(
    {operation(Cylinder{capsule.radius, capsule.length}, pose), operation(end, {pose.position + half, pose.rotation}),
     operation(end, {pose.position - half, pose.rotation})},
    pose.position);
}
}  // namespace

int curveSteps(double arc, double greatest_radius)
{
  const double step = 2.0 * maths::acos(std::max(0.0, 1.0 - kCurveTolerance / greatest_radius));
  return std::max(1, static_cast<int>(std::ceil(arc / step)));
}

Section cut(const Sphere & sphere, const Pose3 & pose, double z)
{
  return ofCircle(pose.position, radiusAt(sphere, z - pose.position.z()));
}

Section shadow(const Sphere & sphere, const Pose3 & pose, double z_min, double z_max)
{
  if (!heightsOf(sphere, pose).overlap(z_min, z_max)) {
    return {};
  }
  const double centre = pose.position.z();
  return ofCircle(pose.position, radiusAt(sphere, std::clamp(centre, z_min, z_max) - centre));
}

Section cut(const Cylinder & cylinder, const Pose3 & pose, double z)
{
  if (cylinder.radius <= kTolerance || !heightsOf(cylinder, pose).contain(z)) {
    return {};
  }
  return standsUpright(pose) ? ofCircle(pose.position, cylinder.radius)
                             : ofPoints(cutPoints(bodyOf(cylinder, pose), z));
}

Section shadow(const Cylinder & cylinder, const Pose3 & pose, double z_min, double z_max)
{
  if (cylinder.radius <= kTolerance || !heightsOf(cylinder, pose).overlap(z_min, z_max)) {
    return {};
  }
  return standsUpright(pose) ? ofCircle(pose.position, cylinder.radius)
                             : ofPoints(shadowPoints(bodyOf(cylinder, pose), z_min, z_max));
}

Section cut(const Capsule & capsule, const Pose3 & pose, double z)
{
  return ofParts(capsule, pose, [z](const auto & part, const Pose3 & place) { return cut(part, place, z); });
}

Section shadow(const Capsule & capsule, const Pose3 & pose, double z_min, double z_max)
{
  return ofParts(
    capsule, pose, [=](const auto & part, const Pose3 & place) { return shadow(part, place, z_min, z_max); });
}
}  // namespace f1tenth_sim2d
