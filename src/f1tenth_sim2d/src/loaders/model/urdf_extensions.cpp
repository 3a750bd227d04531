#include "loaders/model/urdf_extensions.h"

#include "loaders/model/sdf_parts.h"

namespace f1tenth_sim2d
{
namespace
{
const std::string kJoinedMark = "_fixed_joint_lump__";

/// Whether Gazebo gives what an extension says of collisions to one with this name. Those of a link that stays do not
/// get to collision elements that have a name of their own.
bool isMeantFor(const std::string & collision, const std::string & reference, const std::string & link)
{
  if (reference == link) {
    return collision.find(kJoinedMark) == std::string::npos;
  }
  return collision.find(kJoinedMark + reference + "_collision") != std::string::npos;
}
}  // namespace

UrdfExtensions::UrdfExtensions(const Element & robot, const UrdfTree & tree, WarningCollector & warnings)
{
  for (const Element & extension : robot.children("gazebo")) {
    const std::string reference = extension.attribute("reference");
    if (reference.empty()) {
      of_model_.push_back(extension);
    } else if (tree.links().count(reference) > 0) {
      by_reference_[reference].push_back(extension);
    } else if (!tree.hasJoint(reference)) {
      warnings.add("refers to what is neither a link nor a joint and is left out", extension.fileLine());
    }
  }
}

std::vector<Element> UrdfExtensions::ofLink(const UrdfLink & link) const
{
  std::vector<Element> extensions;
  append(link, extensions);
  return extensions;
}

std::string UrdfExtensions::materialOf(const UrdfLink & link) const
{
  std::string material;
  if (const auto own = by_reference_.find(link.name); own != by_reference_.end()) {
    for (const Element & extension : own->second) {
      material = extension.textOf("material", material);
    }
  }
  return material;
}

void UrdfExtensions::append(const UrdfLink & link, std::vector<Element> & extensions) const
{
  if (const auto own = by_reference_.find(link.name); own != by_reference_.end()) {
    extensions.insert(extensions.end(), own->second.begin(), own->second.end());
  }
  for (const UrdfLink * const child : link.children) {
    if (child->isJoined()) {
      append(*child, extensions);
    }
  }
}

void UrdfExtensions::apply(const UrdfLink & link, Solid & solid, WarningCollector & warnings) const
{
  for (const Element & extension : ofLink(link)) {
    if (!isMeantFor(solid.name, extension.attribute("reference"), link.name)) {
      continue;
    }
    for (const Element & collision : extension.children("collision")) {
      if (const Element surface = collision.child("surface")) {
        solid.mu = Solid().mu;
        solid.restitution = Solid().restitution;
        readSurface(surface, solid, warnings);
      }
    }
    if (const Element mu = extension.child("mu1")) {
      solid.mu = frictionOf(mu, mu.toNumber("<mu1>", mu.value()), warnings);
    }
  }
}
}  // namespace f1tenth_sim2d
