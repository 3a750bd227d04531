#include "geometry/mesh_section.h"

#include <algorithm>
#include <array>

#include "geometry/heights.h"
#include "geometry/mesh_outlines.h"
#include "geometry/planar.h"
#include "geometry/polygon_union.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

/// How thick an upright sheet is in a shadow, which consists of areas, m.
constexpr double kSheetThickness = 0.001;
/// A triangle that looks narrower than this from above counts as upright, m.
constexpr double kUprightWidth = 1e-4;

std::vector<Vector3d> placed(const TriangleMesh & mesh, const Pose3 & pose)
{
  std::vector<Vector3d> vertices;
  for (const Vector3d & vertex : mesh.vertices) {
    vertices.push_back(pose * vertex);
  }
  return vertices;
}

/// There and back: all corners, and all but the ends once more.
Outline doubled(Outline line)
{
  const std::size_t n = line.size();
  for (std::size_t i = n - 1; i-- > 1;) {
    line.push_back(line[i]);
  }
  return line;
}

/// Whether a clockwise outline is that of a hollow, with matter around it. Else the triangles of a surface are
/// clockwise seen from outside, whether it is a room or turned inside out by mistake.
bool isWithinMatter(const Outline & hollow, const std::vector<Outline> & outlines)
{
  int layers = 0;
  for (const Outline & outline : outlines) {
    if (&outline != &hollow && contains(outline, hollow.front())) {
      layers += signedArea(outline) > 0.0 ? 1 : -1;
    }
  }
  return layers > 0;
}

/// The part of a convex polygon in space on one side of a horizontal plane.
std::vector<Vector3d> clipped(const std::vector<Vector3d> & polygon, double z, double side)
{
  std::vector<Vector3d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d & a = polygon[i];
    const Vector3d & b = polygon[(i + 1) % polygon.size()];
    const double height_a = side * (a.z() - z);
    const double height_b = side * (b.z() - z);
    if (height_a >= 0.0) {
      kept.push_back(a);
    }
    if (height_a * height_b < 0.0) {
      kept.push_back(a + (b - a) * (height_a / (height_a - height_b)));
    }
  }
  return kept;
}

/// The two points farthest apart in x or y, whichever they differ in most.
std::array<Vec2, 2> extremes(const std::vector<Vec2> & points)
{
  const auto [west, east] =
    std::minmax_element(points.begin(), points.end(), [](const Vec2 & a, const Vec2 & b) { return a.x < b.x; });
  const auto [south, north] =
    std::minmax_element(points.begin(), points.end(), [](const Vec2 & a, const Vec2 & b) { return a.y < b.y; });
  if (east->x - west->x > north->y - south->y) {
    return {*west, *east};
  }
  return {*south, *north};
}

/// The parts of all triangles between two heights, seen from above.
struct Projection
{
  std::vector<Outline> areas;
  std::vector<std::array<Vec2, 2>> lines;  ///< of upright triangles

  void add(const std::vector<Vector3d> & polygon)
  {
    std::vector<Vec2> points;
    points.reserve(polygon.size());
    for (const Vector3d & corner : polygon) {
      points.push_back({corner.x(), corner.y()});
    }
    if (points.empty()) {
      return;
    }
    ConvexPolygon area = convexHull(points);
    const auto line = extremes(points);
    const double length = distance(line[0], line[1]);
    if (length > kTolerance && signedArea(area) < kUprightWidth * length) {
      lines.push_back(line);
    }
    if (!area.empty()) {
      areas.push_back(std::move(area));
    }
  }
};

Projection projectionBetween(
  const TriangleMesh & mesh, const std::vector<Vector3d> & vertices, double z_min, double z_max)
{
  Projection projection;
  for (const auto & triangle : mesh.triangles) {
    const std::vector<Vector3d> corners{vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
    const auto byHeight = [](const Vector3d & a, const Vector3d & b) { return a.z() < b.z(); };
    const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end(), byHeight);
    const bool lies_within = lowest->z() > z_min + kTolerance && highest->z() < z_max - kTolerance;
    if (lies_within || Heights{lowest->z(), highest->z()}.overlap(z_min, z_max)) {
      projection.add(clipped(clipped(corners, z_min, 1.0), z_max, -1.0));
    }
  }
  return projection;
}
}  // namespace

Section cut(const TriangleMesh & mesh, const Pose3 & pose, double z)
{
  MeshOutlines found = outlinesAt(mesh, placed(mesh, pose), z);
  Section section;
  for (const Outline & outline : found.closed) {
    if (signedArea(outline) < 0.0 && !isWithinMatter(outline, found.closed)) {
      found.open.push_back(outline);
      found.open.back().push_back(outline.front());
    } else {
      section.outlines.push_back(outline);
    }
  }
  for (Outline & line : found.open) {
    section.outlines.push_back(doubled(std::move(line)));
  }
  return section;
}

Section shadow(const TriangleMesh & mesh, const Pose3 & pose, double z_min, double z_max)
{
  const std::vector<Vector3d> vertices = placed(mesh, pose);
  const Projection projection = projectionBetween(mesh, vertices, z_min, z_max);
  PolygonUnion area;
  area.add(outlinesAt(mesh, vertices, z_min).closed);
  area.addEach(projection.areas);
  area.addUncovered(projection.lines, kSheetThickness);
  return {area.convexPieces(), {}};
}
}  // namespace f1tenth_sim2d
