#include "loaders/visuals/read_visual.h"

#include <mutex>
#include <optional>
#include <utility>
#include <variant>

#include "f1tenth_sim2d/errors.h"
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
  Pose3 turn;    ///< to its normal
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
    return single(rectangle(sheet.width, sheet.depth, material.scale, toTransform(sheet.turn)));
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

Sheet sheetOf(const Element & plane, const Pose3 & turn)
{
  constexpr double kByDefault = 1.0;  // m, in SDF
  constexpr std::size_t kNumbers = 2;
  const auto size = numbersIn(plane.child("size").text()).value_or(std::vector<double>{});
  const Sheet sheet = size.size() == kNumbers ? Sheet{size[0], size[1], turn} : Sheet{kByDefault, kByDefault, turn};
  plane.requireLength("<size>", sheet.width);
  plane.requireLength("<size>", sheet.depth);
  return sheet;
}

std::variant<Shape, Sheet, MeshFile> shapeOf(const Element & geometry, bool is_urdf, const FileFinder & files)
{
  if (const Element mesh = geometry.child("mesh")) {
    return is_urdf ? MeshFile{mesh.requiredAttribute("filename"), urdfMeshSelectionOf(mesh)}
                   : MeshFile{mesh.requiredText("uri"), meshSelectionOf(mesh)};
  }
  WarningCollector of_meshes;
  MeshLibrary no_meshes(*files.uris, of_meshes);
  Pose3 turn;
  const std::optional<Shape> shape =
    is_urdf ? readUrdfShape(geometry, no_meshes) : readShape(geometry, no_meshes, turn);
  if (std::holds_alternative<Plane>(*shape)) {
    return sheetOf(geometry.child("plane"), turn);
  }
  return *shape;
}

/// Reads no file.
/// @param given  by <gazebo>: name of the material
VisualDescription described(const Element & visual, const FileFinder & files, const std::string & given)
{
  const bool is_urdf = visual.root().is("robot");
  const Element geometry = visual.child("geometry");
  if (!geometry) {
    visual.fail("has no <geometry>");
  }
  VisualDescription description;
  description.place = visual.fileLine();
  description.files = files;
  description.shape = shapeOf(geometry, is_urdf, files);
  description.casts_shadow = visual.flag("cast_shadows", true);
  if (const Element own = visual.child("material"); own || !given.empty()) {
    description.material = is_urdf ? readUrdfMaterial(own, given) : readMaterial(own);
  }
  return description;
}

Appearance appearanceOf(const VisualDescription & visual)
{
  const LoadedMaterial material = loadMaterial(visual.material.value_or(MaterialDescription{}), visual.files);
  Appearance seen;
  seen.warning = material.warning;
  try {
    seen.surfaces = std::visit(Draw{material, visual, seen.warning}, visual.shape);
  } catch (const std::exception & error) {
    seen.warning = std::string(error.what()) + ": not drawn";
  }
  for (Surface & surface : seen.surfaces) {
    surface.casts_shadow = visual.casts_shadow;
  }
  seen.warning = seen.warning.empty() ? "" : visual.place + ": " + seen.warning;
  return seen;
}

/// Keeps the document, of which nothing but the pose is read before somebody looks.
class LookOfVisual : public Look
{
public:
  LookOfVisual(const Element & visual, FileFinder files, std::string material)
  : visual_(visual),
    document_(visual.document().shared_from_this()),
    files_(std::move(files)),
    material_(std::move(material))
  {
  }

private:
  Appearance read() const override { return appearanceOf(description()); }

  VisualDescription description() const
  {
    // tinyxml2 finishes a text when it is read for the first time, and looks may be taken from several threads.
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    return described(visual_, files_, material_);
  }

  const Element visual_;
  const std::shared_ptr<const XmlDocument> document_;
  const FileFinder files_;
  const std::string material_;
};

class NothingToSee : public Look
{
public:
  explicit NothingToSee(std::string why) : why_(std::move(why)) {}

private:
  Appearance read() const override { throw Error(why_); }

  const std::string why_;
};
}  // namespace

Visual readVisual(
  const Element & visual, const std::function<Pose3()> & pose, MeshLibrary & meshes, const std::string & material)
{
  try {
    const Pose3 place = pose();
    visual.requireNear(place.position);
    FileFinder files{meshes.sharedUris(), visual.document().folder};
    return {place, {}, std::make_shared<LookOfVisual>(visual, std::move(files), material)};
  } catch (const LoadError & error) {
    return {{}, {}, std::make_shared<NothingToSee>(error.what())};
  }
}
}  // namespace f1tenth_sim2d
