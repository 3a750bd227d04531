#include "loaders/shapes/mesh_library.h"

#include <tinyxml2.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>
#include <set>
#include <sstream>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"
#include "loaders/xml/xml_document.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

std::string extensionOf(const std::string & path)
{
  return boost::algorithm::to_lower_copy(fs::path(path).extension().string());
}

std::string keyOf(const std::string & path, const MeshSelection & selection)
{
  std::ostringstream key;
  key.precision(17);
  key << path << '\n' << selection.submesh << '\n' << selection.centred << '\n' << selection.scale.transpose();
  return key.str();
}

/// <up_axis> of a DAE file; empty if it has none.
std::string upAxisOf(const std::string & path)
{
  tinyxml2::XMLDocument document;
  document.LoadFile(path.c_str());
  const auto axis = tinyxml2::XMLHandle(document)
                      .FirstChildElement("COLLADA")
                      .FirstChildElement("asset")
                      .FirstChildElement("up_axis")
                      .ToElement();
  return Element(axis, nullptr).text();
}
}  // namespace

std::optional<Mesh> MeshLibrary::read(const Element & element, const std::string & uri, const MeshSelection & selection)
{
  if (!selection.scale.allFinite()) {
    element.fail("<scale> has to be three finite numbers");
  }
  if (selection.scale.cwiseAbs().minCoeff() <= 0.0) {
    warnings_.add("a mesh with a <scale> of 0 is left out", element.fileLine());
    return std::nullopt;
  }
  const std::string path = find(element, uri);
  std::shared_ptr<const TriangleMesh> & mesh = known_[keyOf(path, selection)];
  if (!mesh) {
    mesh = readNew(element, path, selection);
  }
  return Mesh{mesh};
}

std::shared_ptr<const UriLookup> MeshLibrary::sharedUris()
{
  if (!shared_uris_) {
    shared_uris_ = std::make_shared<const UriLookup>(uris_);
  }
  return shared_uris_;
}

std::string MeshLibrary::find(const Element & element, const std::string & uri) const
{
  const std::string path = uris_.findFrom(element.document().folder, uri);
  if (path.empty()) {
    element.fail("<uri> is " + uri + ", which is not found; searched: " + uris_.searchedFolders());
  }
  if (!isFile(path)) {
    element.fail("<uri> is " + uri + ", but " + path + " is not a file");
  }
  return path;
}

std::shared_ptr<const TriangleMesh> MeshLibrary::readNew(
  const Element & element, const std::string & path, const MeshSelection & selection)
{
  const std::string extension = extensionOf(path);
  if (std::set<std::string>{".dae", ".stl", ".obj"}.count(extension) == 0) {
    element.fail("<uri> is " + path + ", allowed are files that end with .dae, .stl or .obj");
  }
  if (const std::string axis = extension == ".dae" ? upAxisOf(path) : ""; !axis.empty() && axis != "Z_UP") {
    warnings_.add("the <up_axis> " + axis + " of a mesh file is passed over, as Gazebo does", element.fileLine());
  }
  try {
    const MeshSurface surface = readMeshFile(path, selection);
    if (surface.left_out > 0) {
      warnings_.add(
        "triangles of " + path +
          " with a corner that is not finite or farther than 100 km from its origin are left out",
        element.fileLine());
    }
    return surface.triangles;
  } catch (const Error & error) {
    element.fail(path + " " + error.what());
  }
}
}  // namespace f1tenth_sim2d
