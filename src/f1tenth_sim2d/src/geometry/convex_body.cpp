#include "geometry/convex_body.h"

#include <algorithm>
#include <cmath>

#include "geometry/heights.h"
#include "geometry/planar.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

Heights heightsOf(const ConvexBody & body)
{
  const auto [lowest, highest] = std::minmax_element(
    body.corners.begin(), body.corners.end(), [](const Vector3d & a, const Vector3d & b) { return a.z() < b.z(); });
  return {lowest->z(), highest->z()};
}

void appendCrossings(const ConvexBody & body, double z, std::vector<Vec2> & points)
{
  for (const auto & [from, to] : body.edges) {
    const Vector3d & a = body.corners[from];
    const Vector3d & b = body.corners[to];
    if ((a.z() - z) * (b.z() - z) < 0.0) {
      const double t = (z - a.z()) / (b.z() - a.z());
      points.push_back({a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y())});
    }
  }
}

void appendCornersBetween(const ConvexBody & body, double z_min, double z_max, std::vector<Vec2> & points)
{
  for (const Vector3d & corner : body.corners) {
    if (corner.z() >= z_min && corner.z() <= z_max) {
      points.push_back({corner.x(), corner.y()});
    }
  }
}
}  // namespace

ConvexBody prism(const ConvexPolygon & base, double z_min, double z_max, const Pose3 & pose)
{
  ConvexBody body;
  const std::size_t n = base.size();
  for (const double z : {z_min, z_max}) {
    for (const Vec2 & corner : base) {
      body.corners.push_back(pose * Vector3d(corner.x, corner.y, z));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    body.edges.insert(body.edges.end(), {{i, next}, {n + i, n + next}, {i, n + i}});
  }
  return body;
}

std::vector<Vec2> cutPoints(const ConvexBody & body, double z)
{
  std::vector<Vec2> points;
  if (heightsOf(body).contain(z)) {
    appendCornersBetween(body, z - kTolerance, z + kTolerance, points);
    appendCrossings(body, z, points);
  }
  return points;
}

std::vector<Vec2> shadowPoints(const ConvexBody & body, double z_min, double z_max)
{
  std::vector<Vec2> points;
  if (heightsOf(body).overlap(z_min, z_max)) {
    appendCornersBetween(body, z_min, z_max, points);
    appendCrossings(body, z_min, points);
    appendCrossings(body, z_max, points);
  }
  return points;
}
}  // namespace f1tenth_sim2d
