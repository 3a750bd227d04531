#include <filesystem>
#include <map>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "loaders/frames/read_pose.h"
#include "loaders/map/map_world.h"
#include "loaders/model/known_tags.h"
#include "loaders/model/model_reader.h"
#include "loaders/world/describe_model.h"
#include "loaders/world/saved_state.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kDefaultGravity = -9.8;
constexpr int kWithGravityOfWorld = 106;

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

Element onlyWorld(const Element & root, const std::string & path)
{
  const std::vector<Element> worlds = root.is("sdf") ? root.children("world") : std::vector<Element>{};
  if (worlds.size() != 1) {
    throw LoadError(path, "", "holds " + std::to_string(worlds.size()) + " worlds, allowed is one <world>");
  }
  return worlds.front();
}

double readGravity(const Element & world)
{
  const Element physics = world.child("physics");
  const bool of_physics = sdfVersion(world) < kWithGravityOfWorld && physics.child("gravity");
  const Eigen::Vector3d gravity = (of_physics ? physics : world).vector("gravity", {0.0, 0.0, kDefaultGravity});
  if (!gravity.allFinite()) {
    world.fail("<gravity> is not finite");
  }
  if (gravity.z() > 0.0) {
    world.fail("z of <gravity> is " + toText(gravity.z()) + ", allowed is at most 0: it points downwards");
  }
  return -gravity.z();
}

void readModels(const Element & world, ModelReader & reader, WorldDescription & description)
{
  FrameScope frames;
  for (const Element & frame : world.children("frame")) {
    frames.add(frame.requiredAttribute("name"), readPose(frame, frame.attribute("attached_to")));
  }
  std::vector<Model> models;
  for (const Element & child : world.children()) {
    if (std::optional<Model> model = reader.readNested(child)) {
      nestFrames(*model, frames, reader.warnings());
      models.push_back(std::move(*model));
    }
  }
  const std::map<std::string, Element> saved = savedModels(world, reader.warnings());
  for (Model & model : models) {
    Pose3 pose = frames.poseOf(model.name, model.element);
    if (const auto state = saved.find(model.name); state != saved.end()) {
      restore(state->second, pose, model, reader.warnings());
    }
    appendModel(model, pose, description.models, reader.warnings());
  }
}

WorldDescription loadSdfWorld(const std::string & path, const SearchPath & search_path)
{
  const UriLookup uris(search_path, path);
  WarningCollector warnings;
  ModelReader reader(uris, warnings);
  const Element root = reader.documents().readFile(path);
  const Element world = onlyWorld(root, path);
  requireSdfVersion(root, warnings);
  WorldDescription description;
  description.file = path;
  description.name = world.name();
  description.gravity = readGravity(world);
  warnOfChildren(world, warnings);
  if (const Element population = world.child("population")) {
    population.fail("is not supported; write its models one by one");
  }
  readModels(world, reader, description);
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
  return isMapFile(path) ? loadMapWorld(path) : loadSdfWorld(path, search_path);
}
}  // namespace f1tenth_sim2d
