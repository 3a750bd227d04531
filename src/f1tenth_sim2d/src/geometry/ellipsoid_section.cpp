#include <workspace_support/maths/trigonometry.h>
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "geometry/heights.h"
#include "geometry/planar.h"
#include "geometry/round_section.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;

/// The points centre + x with x^T shape^-1 x <= 1; u^T shape u is the square of how far they reach along u.
struct Ellipse
{
  Vector2d centre;
  Matrix2d shape;

  bool isCircle() const
  {
    return std::abs(shape(0, 0) - shape(1, 1)) < kTolerance * shape(0, 0) &&
           std::abs(shape(0, 1)) < kTolerance * shape(0, 0);
  }
  Section asCircle() const { return {{}, {{{centre.x(), centre.y()}, std::sqrt(shape(0, 0))}}}; }
  /// The point that is farthest along u.
  Vector2d farthest(const Vector2d & u) const { return centre + shape * u / std::sqrt(u.dot(shape * u)); }
};

/// An ellipsoid in its place.
class PlacedEllipsoid
{
public:
  PlacedEllipsoid(const Ellipsoid & ellipsoid, const Pose3 & pose) : centre_(pose.position)
  {
    const Matrix3d axes = pose.rotation.toRotationMatrix() * ellipsoid.radii.asDiagonal();
    shape_ = axes * axes.transpose();
  }

  Ellipse outline() const { return {centre_.head<2>(), shape_.topLeftCorner<2, 2>()}; }

  Ellipse cutAt(double z) const
  {
    const double height = z - centre_.z();
    const Vector2d lean = shape_.topRightCorner<2, 1>() / shape_(2, 2);
    const double left = std::max(0.0, 1.0 - height * height / shape_(2, 2));
    return {
      centre_.head<2>() + lean * height,
      left * (shape_.topLeftCorner<2, 2>() - shape_(2, 2) * lean * lean.transpose())};
  }

  /// Whether all its cuts have the same centre.
  bool isUpright() const { return shape_.topRightCorner<2, 1>().norm() < kTolerance * shape_(2, 2); }

  /// Height of the point of the surface that is farthest along u, which reaches as far as 1.
  double heightOfFarthest(const Vector2d & u) const { return centre_.z() + shape_.bottomLeftCorner<1, 2>() * u; }

private:
  Eigen::Vector3d centre_;
  Matrix3d shape_;
};

/// Points around an ellipse, and whatever else lies in the same direction.
/// @param point  gives it for a direction along which the ellipse reaches as far as 1
template <typename Point>
Section around(const Ellipse & ellipse, Point point)
{
  const Matrix2d lower = ellipse.shape.llt().matrixL();
  const int steps = 4 * curveSteps(M_PI / 2.0, std::sqrt(ellipse.shape.trace()));
  std::vector<Vec2> points;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2.0 * M_PI * i / steps;
    const Vector2d u = lower.transpose().inverse() * Vector2d(maths::cos(angle), maths::sin(angle));
    const Vector2d p = point(u);
    points.push_back({p.x(), p.y()});
  }
  ConvexPolygon hull = convexHull(points);
  return hull.empty() ? Section{} : Section{{std::move(hull)}, {}};
}
}  // namespace

Section cut(const Ellipsoid & ellipsoid, const Pose3 & pose, double z)
{
  const PlacedEllipsoid placed(ellipsoid, pose);
  const Ellipse ellipse = placed.cutAt(z);
  if (!heightsOf(ellipsoid, pose).contain(z) || ellipse.shape.trace() < kTolerance * kTolerance) {
    return {};
  }
  return ellipse.isCircle() ? ellipse.asCircle()
                            : around(ellipse, [&](const Vector2d & u) { return ellipse.farthest(u); });
}

Section shadow(const Ellipsoid & ellipsoid, const Pose3 & pose, double z_min, double z_max)
{
  if (!heightsOf(ellipsoid, pose).overlap(z_min, z_max)) {
    return {};
  }
  const PlacedEllipsoid placed(ellipsoid, pose);
  const Ellipse outline = placed.outline();
  if (placed.isUpright() && outline.isCircle()) {
    return placed.cutAt(std::clamp(pose.position.z(), z_min, z_max)).asCircle();
  }
  return around(outline, [&](const Vector2d & u) {
    const double z = placed.heightOfFarthest(u);
    return z >= z_min && z <= z_max ? outline.farthest(u) : placed.cutAt(std::clamp(z, z_min, z_max)).farthest(u);
  });
}
}  // namespace f1tenth_sim2d
