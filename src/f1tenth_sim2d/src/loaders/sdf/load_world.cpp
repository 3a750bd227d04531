#include <cmath>
#include <filesystem>
#include <sdf/World.hh>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "loaders/files/uri_lookup.h"
#include "loaders/map/map_world.h"
#include "loaders/sdf/element_reader.h"
#include "loaders/sdf/from_ignition.h"
#include "loaders/sdf/include_cycles.h"
#include "loaders/sdf/sdf_errors.h"
#include "loaders/sdf/sdf_models.h"
#include "loaders/sdf/world_document.h"

namespace f1tenth_sim2d
{
namespace
{

void requireFile(const std::string & path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw LoadError(path, "", "no such file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw LoadError(path, "", "is not a file");
  }
}

/// A world that Gazebo saved carries its models' last poses in <state>, and Gazebo starts from those.
Pose3 startPose(const sdf::World & world, const sdf::Model & model, const std::string & file)
{
  const sdf::ElementPtr state = world.Element()->FindElement("state");
  for (auto saved = state ? state->FindElement("model") : nullptr; saved; saved = saved->GetNextElement("model")) {
    if (saved->Get<std::string>("name") == model.Name() && saved->HasElement("pose")) {
      return fromIgnition(saved->Get<ignition::math::Pose3d>("pose"));
    }
  }
  if (model.PoseRelativeTo().empty()) {
    return fromIgnition(model.RawPose());
  }
  return resolvePose(model.SemanticPose(), "", model.Element(), file);
}

void readWorldChildren(const sdf::World & world, WorldDescription & description, WarningCollector & warnings)
{
  for (auto child = world.Element()->GetFirstElement(); child; child = child->GetNextElement()) {
    const std::string tag = child->GetName();
    if (tag == "population") {
      throw LoadError(description.file, elementPath(child), "is not supported; write its models one by one");
    }
    if (tag == "actor" || tag == "road") {
      warnings.add("<" + tag + "> is left out: it has no collision", elementPath(child));
    } else if (tag == "plugin") {
      description.plugins.push_back(readPlugin(child));
      warnings.add("<plugin> of a world is left out: only cars have plugins", elementPath(child));
    }
  }
}

WorldDescription describe(
  const WorldDocument & document, const std::string & path, MeshLibrary & meshes, WarningCollector & warnings)
{
  const sdf::World & world = *document.world;
  WorldDescription description;
  description.file = path;
  description.name = world.Name();
  description.gravity = -world.Gravity().Z();
  if (!std::isfinite(description.gravity)) {
    throw LoadError(path, elementPath(world.Element()), "<gravity> is not finite");
  }
  readWorldChildren(world, description, warnings);
  for (const sdf::Model * const model : document.models) {
    appendModel(*model, startPose(world, *model, path), path, meshes, description.models, warnings);
  }
  return description;
}

WorldDescription loadSdfWorld(const std::string & path, const SearchPath & search_path)
{
  const UriLookup uris(search_path, path);
  WarningCollector warnings;
  requireEndOfIncludes(path, uris);
  const auto document = readWorldDocument(path, uris, warnings);
  MeshLibrary meshes(uris, warnings);
  WorldDescription description = describe(*document, path, meshes, warnings);
  description.warnings = warnings.messages();
  return description;
}
}  // namespace

WorldDescription emptyWorld()
{
  WorldDescription world;
  world.file = "empty world";
  world.name = "empty";
  return world;
}

WorldDescription loadWorld(const std::string & path, const SearchPath & search_path)
{
  requireFile(path);
  if (isMapFile(path)) {
    return loadMapWorld(path);
  }
  return withLoadErrors(path, [&] { return loadSdfWorld(path, search_path); });
}
}  // namespace f1tenth_sim2d
