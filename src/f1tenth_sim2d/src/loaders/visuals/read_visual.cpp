#include "loaders/visuals/read_visual.h"

#include <optional>
#include <utility>
#include <variant>

#include "f1tenth_sim2d/errors.h"
#include "loaders/frames/read_pose.h"
#include "loaders/shapes/read_shape.h"
#include "loaders/visuals/material.h"
#include "loaders/visuals/mesh_surfaces.h"
#include "loaders/xml/xml_document.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
/// A rectangle in the plane z = 0.
struct Sheet
{
  double width;  ///< m, along x
  double depth;  ///< m, along y
};
struct MeshFile
{
  std::string uri;
  MeshSelection selection;
};
struct VisualDescription
{
  std::variant<Shape, Sheet, MeshFile> shape;
  std::optional<MaterialDescription> material;
  bool casts_shadow{true};
  std::string place;  ///< for messages
  FileFinder files;
};

/// Draws a shape of the description.
struct Draw
{
  const LoadedMaterial & material;
  const VisualDescription & visual;
  std::string & warning;

  std::vector<Surface> operator()(const Shape & shape) const { return std::visit(*this, shape); }
  std::vector<Surface> operator()(const Sheet & sheet) const
  {
    return single(rectangle(sheet.width, sheet.depth, material.scale));
  }
  std::vector<Surface> operator()(const MeshFile & mesh) const
  {
    std::string of_mesh;
    std::vector<Surface> surfaces = surfacesOfMesh(
      visual.files.find(mesh.uri), mesh.selection,
      visual.material ? std::make_optional(material.material) : std::nullopt, of_mesh);
    warning += of_mesh;
    return surfaces;
  }
  // Readers make sheets and mesh files of them.
  std::vector<Surface> operator()(const Plane & /*plane*/) const { return {}; }
  std::vector<Surface> operator()(const Mesh & /*mesh*/) const { return {}; }
  template <typename Solid>
  std::vector<Surface> operator()(const Solid & solid) const
  {
    return single(meshOf(solid, material.scale));
  }
  std::vector<Surface> single(std::shared_ptr<const SurfaceMesh> mesh) const
  {
    return {{std::move(mesh), material.material}};
  }
};

class LookOfVisual : public Look
{
public:
  explicit LookOfVisual(VisualDescription visual) : visual_(std::move(visual)) {}

private:
  Appearance read() const override
  {
    const LoadedMaterial material = loadMaterial(visual_.material.value_or(MaterialDescription{}), visual_.files);
    Appearance seen;
    seen.warning = material.warning;
    try {
      seen.surfaces = std::visit(Draw{material, visual_, seen.warning}, visual_.shape);
    } catch (const std::exception & error) {
      seen.warning = std::string(error.what()) + ": not drawn";
    }
    for (Surface & surface : seen.surfaces) {
      surface.casts_shadow = visual_.casts_shadow;
    }
    seen.warning = seen.warning.empty() ? "" : visual_.place + ": " + seen.warning;
    return seen;
  }

  const VisualDescription visual_;
};

class NothingToSee : public Look
{
public:
  explicit NothingToSee(std::string why) : why_(std::move(why)) {}

private:
  Appearance read() const override { return {{}, why_}; }

  const std::string why_;
};

Sheet sheetOf(const Element & plane)
{
  constexpr double kByDefault = 1.0;  // m, in SDF
  constexpr std::size_t kNumbers = 2;
  const auto size = numbersIn(plane.child("size").text()).value_or(std::vector<double>{});
  const Sheet sheet = size.size() == kNumbers ? Sheet{size[0], size[1]} : Sheet{kByDefault, kByDefault};
  plane.requireLength("<size>", sheet.width);
  plane.requireLength("<size>", sheet.depth);
  return sheet;
}

/// @param pose  of the shape, turned to the normal of a plane
std::variant<Shape, Sheet, MeshFile> readSdfShape(const Element & geometry, MeshLibrary & meshes, Pose3 & pose)
{
  if (const Element mesh = geometry.child("mesh")) {
    return MeshFile{mesh.requiredText("uri"), meshSelectionOf(mesh)};
  }
  const std::optional<Shape> shape = readShape(geometry, meshes, pose);
  if (const Element plane = geometry.child("plane")) {
    return sheetOf(plane);
  }
  return *shape;
}

std::variant<Shape, Sheet, MeshFile> readUrdf(const Element & geometry, MeshLibrary & meshes)
{
  if (const Element mesh = geometry.child("mesh")) {
    return MeshFile{mesh.requiredAttribute("filename"), urdfMeshSelectionOf(mesh)};
  }
  return *readUrdfShape(geometry, meshes);
}

Element geometryOf(const Element & visual)
{
  const Element geometry = visual.child("geometry");
  if (!geometry) {
    visual.fail("has no <geometry>");
  }
  return geometry;
}

VisualDescription described(const Element & visual, MeshLibrary & meshes)
{
  VisualDescription description;
  description.place = visual.fileLine();
  description.files = {meshes.sharedUris(), visual.document().folder};
  return description;
}
}  // namespace

Visual readVisual(const Element & visual, const std::string & link, const FrameScope & frames, MeshLibrary & meshes)
{
  try {
    Pose3 turned;
    VisualDescription description = described(visual, meshes);
    description.shape = readSdfShape(geometryOf(visual), meshes, turned);
    description.casts_shadow = visual.flag("cast_shadows", true);
    if (const Element material = visual.child("material")) {
      description.material = readMaterial(material);
    }
    const Pose3 pose = frames.resolved(readPose(visual, link)) * turned;
    visual.requireNear(pose.position);
    return {pose, {}, std::make_shared<LookOfVisual>(std::move(description))};
  } catch (const LoadError & error) {
    return {{}, {}, std::make_shared<NothingToSee>(std::string(error.what()) + ": not drawn")};
  }
}

Visual readUrdfVisual(const Element & visual, const Pose3 & link, const std::string & material, MeshLibrary & meshes)
{
  try {
    VisualDescription description = described(visual, meshes);
    description.shape = readUrdf(geometryOf(visual), meshes);
    if (const Element own = visual.child("material"); own || !material.empty()) {
      description.material = readUrdfMaterial(own, material);
    }
    const Pose3 pose = link * readOrigin(visual);
    visual.requireNear(pose.position);
    return {pose, {}, std::make_shared<LookOfVisual>(std::move(description))};
  } catch (const LoadError & error) {
    return {{}, {}, std::make_shared<NothingToSee>(std::string(error.what()) + ": not drawn")};
  }
}
}  // namespace f1tenth_sim2d
