#include "loaders/files/mesh_library.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/xml_text.h"
#include "loaders/sdf/element_reader.h"
#include "loaders/sdf/from_ignition.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

std::string extensionOf(const std::string & path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(
    extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

MeshSelection readSelection(const sdf::ElementPtr & mesh, const std::string & file)
{
  MeshSelection selection;
  selection.scale = fromIgnition(mesh->Get("scale", ignition::math::Vector3d::One).first);
  if (!selection.scale.allFinite() || selection.scale.cwiseAbs().minCoeff() <= 0.0) {
    ElementReader(mesh, file).fail("<scale> has to be three finite numbers, none of them 0");
  }
  if (const sdf::ElementPtr submesh = descend(mesh, {"submesh"})) {
    selection.submesh = ElementReader(submesh, file).requiredText("name");
    selection.centred = submesh->Get<bool>("center", false).first;
  }
  return selection;
}

std::string keyOf(const std::string & path, const MeshSelection & selection)
{
  std::ostringstream key;
  key.precision(17);
  key << path << '\n' << selection.submesh << '\n' << selection.centred << '\n' << selection.scale.transpose();
  return key.str();
}

/// <up_axis> of a DAE file; empty if it says nothing.
std::string upAxisOf(const std::string & path)
{
  tinyxml2::XMLDocument document;
  document.LoadFile(path.c_str());
  const auto axis = tinyxml2::XMLHandle(document)
                      .FirstChildElement("COLLADA")
                      .FirstChildElement("asset")
                      .FirstChildElement("up_axis")
                      .ToElement();
  return textOf(axis);
}
}  // namespace

Mesh MeshLibrary::read(const sdf::ElementPtr & element, const std::string & file)
{
  const std::string path = find(element, file);
  const MeshSelection selection = readSelection(element, file);
  std::shared_ptr<const TriangleMesh> & mesh = known_[keyOf(path, selection)];
  if (!mesh) {
    mesh = readNew(element, path, selection, file);
  }
  return {mesh};
}

/// A URI without scheme is a path beside the file that it stands in.
std::string MeshLibrary::find(const sdf::ElementPtr & element, const std::string & file) const
{
  const ElementReader reader(element, file);
  const std::string uri = reader.requiredText("uri");
  const fs::path beside = fs::path(element->FilePath()).parent_path() / uri;
  std::error_code ignored;
  if (uri.find("://") == std::string::npos && fs::is_regular_file(beside, ignored)) {
    return beside.string();
  }
  const std::string path = uris_.find(uri);
  if (path.empty()) {
    reader.fail("<uri> is " + uri + ", which is not found; searched: " + uris_.searchedFolders());
  }
  if (!fs::is_regular_file(path, ignored)) {
    reader.fail("<uri> is " + uri + ", but " + path + " is not a file");
  }
  return path;
}

std::shared_ptr<const TriangleMesh> MeshLibrary::readNew(
  const sdf::ElementPtr & element, const std::string & path, const MeshSelection & selection, const std::string & file)
{
  const ElementReader reader(element, file);
  const std::string extension = extensionOf(path);
  if (std::set<std::string>{".dae", ".stl", ".obj"}.count(extension) == 0) {
    reader.fail("<uri> is " + path + ", allowed are files that end with .dae, .stl or .obj");
  }
  if (const std::string axis = extension == ".dae" ? upAxisOf(path) : ""; !axis.empty() && axis != "Z_UP") {
    warnings_.add("the <up_axis> " + axis + " of a mesh file is passed over, as Gazebo does", elementPath(element));
  }
  try {
    return readMeshFile(path, selection);
  } catch (const Error & error) {
    reader.fail(path + " " + error.what());
  }
}
}  // namespace f1tenth_sim2d
