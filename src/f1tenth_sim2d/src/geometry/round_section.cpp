#include "geometry/round_section.h"

#include <algorithm>
#include <cmath>

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

/// A cylinder seen along the direction in which its axis leans: u is that direction in the ground plane, v is to its
/// left. The axis is (sine, 0, cosine) in (u, v, z).
class LeaningCylinder
{
public:
  LeaningCylinder(const Cylinder & cylinder, const Pose3 & pose)
  : centre_(pose.position), radius_(cylinder.radius), half_length_(cylinder.length / 2.0)
  {
    Vector3d axis = pose.up();
    if (axis.z() < 0.0) {
      axis = -axis;
    }
    sine_ = std::hypot(axis.x(), axis.y());
    cosine_ = axis.z();
    direction_ = upright() ? Vec2{1.0, 0.0} : Vec2{axis.x() / sine_, axis.y() / sine_};
  }

  bool upright() const { return sine_ < kUprightSine; }

  void appendCut(double z, std::vector<Vec2> & points) const
  {
    const double h = z - centre_.z();
    const double u_min = (-half_length_ - h * cosine_) / sine_;
    const double u_max = (half_length_ - h * cosine_) / sine_;
    // Distance from the axis at right angles to v; it varies along u unless the cylinder lies flat.
    const double w_min = std::max(u_min * cosine_ - h * sine_, -radius_);
    const double w_max = std::min(u_max * cosine_ - h * sine_, radius_);
    if (w_min > w_max) {
      return;
    }
    const double t_first = std::acos(std::clamp(w_max / radius_, -1.0, 1.0));
    const double t_last = std::acos(std::clamp(w_min / radius_, -1.0, 1.0));
    if (cosine_ < kTolerance) {
      appendPair(u_min, radius_ * std::sin(t_first), points);
      appendPair(u_max, radius_ * std::sin(t_first), points);
      return;
    }
    const int steps = curveSteps(t_last - t_first, radius_ / cosine_);
    for (int i = 0; i <= steps; ++i) {
      const double t = t_first + (t_last - t_first) * i / steps;
      const double u = (radius_ * std::cos(t) + h * sine_) / cosine_;
      appendPair(std::clamp(u, u_min, u_max), radius_ * std::sin(t), points);
    }
  }

  void appendCapsBetween(double z_min, double z_max, std::vector<Vec2> & points) const
  {
    const int steps = 4 * curveSteps(M_PI / 2.0, radius_);  // the outermost points are among them
    for (const double side : {-half_length_, half_length_}) {
      for (int i = 0; i < steps; ++i) {
        const double t = 2.0 * M_PI * i / steps;
        const double w = radius_ * std::cos(t);
        const double z = centre_.z() + side * cosine_ - w * sine_;
        if (z >= z_min && z <= z_max) {
          points.push_back(toWorld(side * sine_ + w * cosine_, radius_ * std::sin(t)));
        }
      }
    }
  }

private:
  Vec2 toWorld(double u, double v) const
  {
    return {
      centre_.x() + u * direction_.x - v * direction_.y,  //
      centre_.y() + u * direction_.y + v * direction_.x};
  }

  void appendPair(double u, double v, std::vector<Vec2> & points) const
  {
    points.push_back(toWorld(u, v));
    points.push_back(toWorld(u, -v));
  }

  Vector3d centre_;
  double radius_;
  double half_length_;
  double sine_;
  double cosine_;
  Vec2 direction_;
};

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

void appendPoints(const Circle & circle, std::vector<Vec2> & points)
{
  const int steps = 4 * curveSteps(M_PI / 2.0, circle.radius);
  for (int i = 0; i < steps; ++i) {
    const double angle = 2.0 * M_PI * i / steps;
    points.push_back(
      {circle.centre.x + circle.radius * std::cos(angle), circle.centre.y + circle.radius * std::sin(angle)});
  }
}

/// The union of parts that together are convex; circles with the same centre stay a circle.
Section joined(const std::vector<Section> & parts, const Vector3d & middle)
{
  std::vector<Vec2> points;
  double radius = 0.0;
  bool only_circles = true;
  for (const Section & part : parts) {
    for (const Circle & circle : part.circles) {
      appendPoints(circle, points);
      radius = std::max(radius, circle.radius);
      only_circles =
        only_circles && std::hypot(circle.centre.x - middle.x(), circle.centre.y - middle.y()) < kTolerance;
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
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - kCurveTolerance / greatest_radius));
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
  const LeaningCylinder leaning(cylinder, pose);
  if (leaning.upright()) {
    return ofCircle(pose.position, cylinder.radius);
  }
  std::vector<Vec2> points;
  leaning.appendCut(z, points);
  return ofPoints(points);
}

Section shadow(const Cylinder & cylinder, const Pose3 & pose, double z_min, double z_max)
{
  const Heights heights = heightsOf(cylinder, pose);
  if (cylinder.radius <= kTolerance || !heights.overlap(z_min, z_max)) {
    return {};
  }
  const LeaningCylinder leaning(cylinder, pose);
  if (leaning.upright()) {
    return ofCircle(pose.position, cylinder.radius);
  }
  std::vector<Vec2> points;
  leaning.appendCapsBetween(z_min, z_max, points);
  for (const double z : {z_min, z_max}) {
    if (heights.contain(z)) {
      leaning.appendCut(z, points);
    }
  }
  return ofPoints(points);
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
