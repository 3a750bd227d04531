#include "f1tenth_sim2d/section.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

#include "geometry/convex_body.h"
#include "geometry/heights.h"
#include "geometry/mesh_section.h"
#include "geometry/planar.h"
#include "geometry/round_section.h"

namespace f1tenth_sim2d
{
namespace
{
/// Whether the z axis of pose points straight up, so that what is extruded along it shows its outline unchanged.
bool isUpright(const Pose3 & pose)
{
  const Eigen::Vector3d up = pose.up();
  return up.z() > 0.0 && maths::hypot(up.x(), up.y()) < kTolerance;
}

/// Polygons of an upright frame, in the world.
std::vector<Outline> moved(std::vector<Outline> polygons, const Pose3 & pose)
{
  for (Outline & polygon : polygons) {
    for (Vec2 & corner : polygon) {
      const Eigen::Vector3d there = pose * Eigen::Vector3d(corner.x, corner.y, 0.0);
      corner = {there.x(), there.y()};
    }
  }
  return polygons;
}

Heights uprightHeights(const Polyline & polyline, const Pose3 & pose)
{
  return {pose.position.z(), pose.position.z() + polyline.height};
}

ConvexBody body(const Box & box, const Pose3 & pose)
{
  const double x = box.size.x() / 2.0;
  const double y = box.size.y() / 2.0;
  const double z = box.size.z() / 2.0;
  return prism({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, -z, z, pose);
}

/// @param points  cutPoints or shadowPoints of a convex piece of the extruded area
template <typename Points>
Section ofPieces(const Polyline & polyline, const Pose3 & pose, Points points)
{
  Section section;
  for (const ConvexPolygon & base : polyline.pieces) {
    if (ConvexPolygon piece = convexHull(points(prism(base, 0.0, polyline.height, pose))); !piece.empty()) {
      section.outlines.push_back(std::move(piece));
    }
  }
  return section;
}

Section ofPolygon(Outline polygon)
{
  return polygon.empty() ? Section{} : Section{{std::move(polygon)}, {}};
}

struct CutAt
{
  const Pose3 & pose;
  double z;

  Section operator()(const Box & box) const { return ofPolygon(convexHull(cutPoints(body(box, pose), z))); }
  Section operator()(const Cylinder & cylinder) const { return cut(cylinder, pose, z); }
  Section operator()(const Sphere & sphere) const { return cut(sphere, pose, z); }
  Section operator()(const Capsule & capsule) const { return cut(capsule, pose, z); }
  Section operator()(const Ellipsoid & ellipsoid) const { return cut(ellipsoid, pose, z); }
  Section operator()(const Polyline & polyline) const
  {
    if (isUpright(pose)) {  // in one piece: a cut has no seams where the solid has none
      return uprightHeights(polyline, pose).contain(z) ? Section{moved(polyline.outlines, pose), {}} : Section{};
    }
    return ofPieces(polyline, pose, [this](const ConvexBody & piece) { return cutPoints(piece, z); });
  }
  Section operator()(const Plane &) const { return {}; }
  Section operator()(const Mesh & mesh) const { return cut(*mesh.surface, pose, z); }
};

struct ShadowBetween
{
  const Pose3 & pose;
  double z_min;
  double z_max;

  Section operator()(const Box & box) const
  {
    return ofPolygon(convexHull(shadowPoints(body(box, pose), z_min, z_max)));
  }
  Section operator()(const Cylinder & cylinder) const { return shadow(cylinder, pose, z_min, z_max); }
  Section operator()(const Sphere & sphere) const { return shadow(sphere, pose, z_min, z_max); }
  Section operator()(const Capsule & capsule) const { return shadow(capsule, pose, z_min, z_max); }
  Section operator()(const Ellipsoid & ellipsoid) const { return shadow(ellipsoid, pose, z_min, z_max); }
  Section operator()(const Polyline & polyline) const
  {
    if (isUpright(pose)) {
      return uprightHeights(polyline, pose).overlap(z_min, z_max) ? Section{moved(polyline.pieces, pose), {}}
                                                                  : Section{};
    }
    return ofPieces(polyline, pose, [this](const ConvexBody & piece) { return shadowPoints(piece, z_min, z_max); });
  }
  Section operator()(const Plane &) const { return {}; }
  Section operator()(const Mesh & mesh) const { return shadow(*mesh.surface, pose, z_min, z_max); }
};

void append(Section & all, const std::vector<Solid> & solids, const Pose3 & frame, double z)
{
  for (const Solid & solid : solids) {
    const Section section = sectionAt(solid, frame * solid.pose, z);
    all.outlines.insert(all.outlines.end(), section.outlines.begin(), section.outlines.end());
    all.circles.insert(all.circles.end(), section.circles.begin(), section.circles.end());
  }
}
}  // namespace

Section sectionAt(const Solid & solid, const Pose3 & pose, double z)
{
  return std::visit(CutAt{pose, z}, solid.shape);
}

Section sectionAt(const std::vector<Solid> & solids, const Pose3 & frame, double z)
{
  Section all;
  append(all, solids, frame, z);
  return all;
}

Section staticSectionAt(const WorldDescription & world, double z)
{
  Section all;
  for (const ModelDescription & model : world.models) {
    if (model.is_static) {
      append(all, model.solids, model.pose, z);
    }
  }
  return all;
}

Section footprintBetween(const Solid & solid, const Pose3 & pose, double z_min, double z_max)
{
  return std::visit(ShadowBetween{pose, z_min, z_max}, solid.shape);
}
}  // namespace f1tenth_sim2d
