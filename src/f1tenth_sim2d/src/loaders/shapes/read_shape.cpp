#include "loaders/shapes/read_shape.h"

#include <cmath>

#include "f1tenth_sim2d/section.h"
#include "geometry/planar.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

const char * const kAllowedShapes =
  "<box>, <capsule>, <cylinder>, <ellipsoid>, <sphere>, <polyline>, <plane> and <mesh>";
const char * const kAllowedUrdfShapes = "<box>, <cylinder>, <sphere>, <capsule> and <mesh>";

Vector3d lengths(const Element & element, const std::string & what, const Vector3d & given)
{
  for (const double length : given) {
    element.requireLength(what, length);
  }
  return given;
}

double lengthAttribute(const Element & element, const char * attribute)
{
  const double length = element.numberAttribute(attribute);
  element.requireLength("attribute '" + std::string(attribute) + "'", length);
  return length;
}

/// A plane is a half space; its pose turns z to the normal.
Plane readPlane(const Element & plane, Pose3 & pose)
{
  const Vector3d normal = plane.vector("normal", Vector3d::UnitZ());
  if (!normal.allFinite() || normal.norm() < kTolerance) {
    plane.fail("<normal> has no direction");
  }
  pose.rotation = pose.rotation * Pose3::Rotation::FromTwoVectors(Vector3d::UnitZ(), normal);
  return {};
}

Outline readOutline(const Element & polyline)
{
  Outline outline;
  for (const Element & point : polyline.children("point")) {
    const auto corner = numbersIn(point.text());
    if (!corner || corner->size() != 2) {
      point.fail("is '" + point.text() + "', allowed are two numbers");
    }
    polyline.requireNear({corner->at(0), corner->at(1), 0.0});
    outline.push_back({corner->at(0), corner->at(1)});
  }
  if (!isSimple(outline)) {
    polyline.fail("is not an outline: allowed are at least three points whose edges enclose an area and do not cross");
  }
  return outline;
}

/// All <polyline> of a geometry: those within others are holes.
Polyline readPolylines(const Element & geometry)
{
  std::vector<Outline> outlines;
  for (const Element & polyline : geometry.children("polyline")) {
    outlines.push_back(readOutline(polyline));
  }
  Polyline solid = extrude(outlines, geometry.child("polyline").length("height"));
  if (solid.outlines.empty()) {
    geometry.fail("has <polyline>s that leave nothing: what an even number of them enclose is empty");
  }
  return solid;
}

Element onlyShape(const Element & geometry, const char * allowed)
{
  const std::vector<Element> shapes = geometry.children();
  if (shapes.empty()) {
    geometry.fail(std::string("is empty; allowed are ") + allowed);
  }
  return shapes.front();
}
}  // namespace

MeshSelection meshSelectionOf(const Element & mesh)
{
  MeshSelection selection;
  selection.scale = mesh.vector("scale", Vector3d::Ones());
  if (const Element submesh = mesh.child("submesh")) {
    selection.submesh = submesh.requiredText("name");
    selection.centred = submesh.flag("center", false);
  }
  return selection;
}

MeshSelection urdfMeshSelectionOf(const Element & mesh)
{
  MeshSelection selection;
  if (mesh.has("scale")) {
    selection.scale = mesh.toVector("attribute 'scale'", mesh.attribute("scale"));
  }
  return selection;
}

std::optional<Shape> readShape(const Element & geometry, MeshLibrary & meshes, Pose3 & pose)
{
  const Element shape = onlyShape(geometry, kAllowedShapes);
  if (shape.is("box")) {
    shape.requiredText("size");
    return Box{lengths(shape, "<size>", shape.vector("size", {}))};
  }
  if (shape.is("cylinder")) {
    return Cylinder{shape.length("radius"), shape.length("length")};
  }
  if (shape.is("capsule")) {
    return Capsule{shape.length("radius"), shape.length("length")};
  }
  if (shape.is("sphere")) {
    return Sphere{shape.length("radius")};
  }
  if (shape.is("ellipsoid")) {
    shape.requiredText("radii");
    return Ellipsoid{lengths(shape, "<radii>", shape.vector("radii", {}))};
  }
  if (shape.is("polyline")) {
    return readPolylines(geometry);
  }
  if (shape.is("plane")) {
    return readPlane(shape, pose);
  }
  if (shape.is("mesh")) {
    return meshes.read(shape, shape.requiredText("uri"), meshSelectionOf(shape));
  }
  shape.fail(std::string("is not supported as a collision; allowed are ") + kAllowedShapes);
}

std::optional<Shape> readUrdfShape(const Element & geometry, MeshLibrary & meshes)
{
  const Element shape = onlyShape(geometry, kAllowedUrdfShapes);
  if (shape.is("box")) {
    const std::string size = shape.requiredAttribute("size");
    return Box{lengths(shape, "attribute 'size'", shape.toVector("attribute 'size'", size))};
  }
  if (shape.is("cylinder")) {
    return Cylinder{lengthAttribute(shape, "radius"), lengthAttribute(shape, "length")};
  }
  if (shape.is("capsule")) {
    return Capsule{lengthAttribute(shape, "radius"), lengthAttribute(shape, "length")};
  }
  if (shape.is("sphere")) {
    return Sphere{lengthAttribute(shape, "radius")};
  }
  if (shape.is("mesh")) {
    return meshes.read(shape, shape.requiredAttribute("filename"), urdfMeshSelectionOf(shape));
  }
  shape.fail(std::string("is not supported as a collision; allowed are ") + kAllowedUrdfShapes);
}
}  // namespace f1tenth_sim2d
