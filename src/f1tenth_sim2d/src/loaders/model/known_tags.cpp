#include "loaders/model/known_tags.h"

#include <map>
#include <string>

namespace f1tenth_sim2d
{
namespace
{
/// The children that SDF knows, with the reason why one is left out; null for those read or without effect here.
const std::map<std::string, std::map<std::string, const char *>> kChildren{
  {"world",
   {{"actor", "it has no collision"},
    {"atmosphere", nullptr},
    {"audio", nullptr},
    {"frame", nullptr},
    {"gravity", nullptr},
    {"gui", nullptr},
    {"include", nullptr},
    {"joint", nullptr},
    {"light", nullptr},
    {"magnetic_field", nullptr},
    {"model", nullptr},
    {"physics", nullptr},
    {"plugin", "only cars have plugins"},
    {"population", nullptr},
    {"road", "it has no collision"},
    {"scene", nullptr},
    {"spherical_coordinates", nullptr},
    {"state", nullptr},
    {"wind", nullptr}}},
  {"model",
   {{"allow_auto_disable", nullptr},
    {"enable_wind", nullptr},
    {"frame", nullptr},
    {"gripper", "it does not grip"},
    {"include", nullptr},
    {"joint", nullptr},
    {"link", nullptr},
    {"model", nullptr},
    {"plugin", nullptr},
    {"pose", nullptr},
    {"self_collide", nullptr},
    {"static", nullptr}}},
  {"link",
   {{"audio_sink", "nothing is heard"},
    {"audio_source", "nothing is heard"},
    {"battery", "nothing runs out"},
    {"collision", nullptr},
    {"enable_wind", nullptr},
    {"frame", nullptr},
    {"gravity", nullptr},
    {"inertial", nullptr},
    {"kinematic", nullptr},
    {"light", nullptr},
    {"must_be_base_link", nullptr},
    {"particle_emitter", "a lidar does not see smoke"},
    {"plugin", "plugins belong to models and sensors"},
    {"pose", nullptr},
    {"projector", "a lidar does not see light"},
    {"self_collide", nullptr},
    {"sensor", nullptr},
    {"velocity_decay", nullptr},
    {"visual", nullptr}}},
  {"collision",
   {{"frame", nullptr},
    {"geometry", nullptr},
    {"laser_retro", nullptr},
    {"max_contacts", nullptr},
    {"pose", nullptr},
    {"surface", nullptr}}},
  {"inertial",
   {{"auto_inertia_params", nullptr},
    {"density", nullptr},
    {"fluid_added_mass", nullptr},
    {"frame", nullptr},
    {"inertia", nullptr},
    {"mass", nullptr},
    {"pose", nullptr}}},
  {"box", {{"size", nullptr}}},
  {"capsule", {{"length", nullptr}, {"radius", nullptr}}},
  {"cylinder", {{"length", nullptr}, {"radius", nullptr}}},
  {"ellipsoid", {{"radii", nullptr}}},
  {"mesh", {{"scale", nullptr}, {"submesh", nullptr}, {"uri", nullptr}}},
  {"plane", {{"normal", nullptr}, {"size", nullptr}}},
  {"polyline", {{"height", nullptr}, {"point", nullptr}}},
  {"sphere", {{"radius", nullptr}}},
};
}  // namespace

void warnOfChildren(const Element & parent, WarningCollector & warnings)
{
  const auto & known = kChildren.at(parent.tag());
  for (const Element & child : parent.children()) {
    const std::string tag = child.tag();
    const auto found = known.find(tag);
    const bool is_custom = tag.find(':') != std::string::npos;
    if (found == known.end() && !is_custom) {
      warnings.add("is not an element of SDF and left out", child.fileLine());
    } else if (found != known.end() && found->second) {
      warnings.add("<" + tag + "> of a " + parent.tag() + " is left out: " + found->second, child.fileLine());
    }
  }
}
}  // namespace f1tenth_sim2d
