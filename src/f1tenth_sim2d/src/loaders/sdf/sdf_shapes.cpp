#include "loaders/sdf/sdf_shapes.h"

#include <cmath>
#include <ignition/math/Vector2.hh>
#include <sdf/Geometry.hh>
#include <sdf/Plane.hh>

#include "geometry/planar.h"
#include "loaders/sdf/element_reader.h"
#include "loaders/sdf/from_ignition.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

const char * const kAllowedShapes = "<box>, <cylinder>, <sphere>, <polyline>, <plane> and <mesh>";

Box readBox(const ElementReader & element)
{
  const auto size = fromIgnition(element.required<ignition::math::Vector3d>("size"));
  for (const double edge : {size.x(), size.y(), size.z()}) {
    element.requireLength("size", edge);
  }
  return {size};
}

/// A plane is a half space; its pose turns z to the normal.
Plane readPlane(const ElementReader & element, const sdf::ElementPtr & plane, Pose3 & pose)
{
  const auto normal = fromIgnition(plane->Get("normal", ignition::math::Vector3d::UnitZ).first);
  if (!normal.allFinite() || normal.norm() < kTolerance) {
    element.fail("<normal> has no direction");
  }
  pose.rotation.setFromTwoVectors(Vector3d::UnitZ(), normal);
  return {};
}

Polyline readPolyline(const ElementReader & element, const sdf::ElementPtr & polyline)
{
  if (polyline->GetNextElement("polyline")) {
    element.fail("has a second <polyline> beside it; allowed is one, holes are not supported");
  }
  Outline outline;
  for (auto point = polyline->FindElement("point"); point; point = point->GetNextElement("point")) {
    const auto corner = point->Get<ignition::math::Vector2d>();
    element.requireNear({corner.X(), corner.Y(), 0.0});
    outline.push_back({corner.X(), corner.Y()});
  }
  if (!isSimple(outline)) {
    element.fail("is not an outline: allowed are at least three points whose edges enclose an area and do not cross");
  }
  return {withoutRedundantCorners(outline), element.length("height")};
}

Shape readShape(const sdf::ElementPtr & geometry, const std::string & file, MeshLibrary & meshes, Pose3 & pose)
{
  const sdf::ElementPtr kind = geometry->GetFirstElement();
  if (!kind) {
    ElementReader(geometry, file).fail(std::string("is empty; allowed are ") + kAllowedShapes);
  }
  const ElementReader element(kind, file);
  const std::string name = kind->GetName();
  if (name == "box") {
    return readBox(element);
  }
  if (name == "cylinder") {
    return Cylinder{element.length("radius"), element.length("length")};
  }
  if (name == "sphere") {
    return Sphere{element.length("radius")};
  }
  if (name == "polyline") {
    return readPolyline(element, kind);
  }
  if (name == "plane") {
    return readPlane(element, kind, pose);
  }
  if (name == "mesh") {
    return meshes.read(kind, file);
  }
  element.fail(std::string("is not supported as a collision; allowed are ") + kAllowedShapes);
}
}  // namespace

Solid readCollision(
  const sdf::Collision & collision, const std::string & scoped_name, const std::string & file, MeshLibrary & meshes)
{
  Solid solid;
  solid.name = scoped_name;
  const sdf::ElementPtr element = collision.Element();
  const sdf::ElementPtr geometry = descend(element, {"geometry"});
  if (!geometry) {
    ElementReader(element, file).fail("has no <geometry>");
  }
  solid.shape = readShape(geometry, file, meshes, solid.pose);
  if (const auto friction = descend(element, {"surface", "friction", "ode"})) {
    solid.mu = ElementReader(friction, file).notNegative("mu", solid.mu);
  }
  if (const auto bounce = descend(element, {"surface", "bounce"})) {
    solid.restitution = ElementReader(bounce, file).notNegative("restitution_coefficient", solid.restitution);
  }
  return solid;
}
}  // namespace f1tenth_sim2d
