#include "loaders/car/robot_text.h"

#include <tinyxml2.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <sdf/Link.hh>

#include "f1tenth_sim2d/errors.h"
#include "loaders/car/urdf_extras.h"
#include "loaders/sdf/element_reader.h"
#include "loaders/sdf/sdf_models.h"

namespace f1tenth_sim2d
{
namespace
{

Pose3 toPose(const urdf::Pose & pose)
{
  return {
    {pose.position.x, pose.position.y, pose.position.z},
    {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z}};
}

Pose3 poseInRoot(urdf::LinkConstSharedPtr link)
{
  Pose3 pose;
  for (; link->parent_joint; link = link->getParent()) {
    pose = toPose(link->parent_joint->parent_to_joint_origin_transform) * pose;
  }
  return pose;
}

std::string baseFrameOf(const std::map<std::string, Pose3> & links, const std::string & root)
{
  for (const char * const name : {"base_footprint", "base_link"}) {
    if (links.count(name) > 0) {
      return name;
    }
  }
  return root;
}

bool canVanish(const urdf::Link & link)
{
  const bool has_mass = link.inertial && link.inertial->mass > 0.0;
  return !has_mass && (!link.parent_joint || link.parent_joint->type != urdf::Joint::FIXED);
}
}  // namespace

std::string rootElement(const std::string & xml, const std::string & source)
{
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.c_str(), xml.size()) != tinyxml2::XML_SUCCESS) {
    static const std::string prefix = "XML_ERROR_";
    const std::string name = document.ErrorName();
    const int line = document.ErrorLineNum();
    throw LoadError(
      source, line > 0 ? "line " + std::to_string(line) : "",
      "malformed XML: " + (name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : name));
  }
  const tinyxml2::XMLElement * const root = document.RootElement();
  return root ? root->Name() : "";
}

RobotFacts readUrdf(
  const std::string & xml, const std::string & source, const SdfMessages & messages, WarningCollector & warnings)
{
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(xml);
  if (const auto errors = messages.errors(); !robot || !errors.empty()) {
    throw LoadError(source, "robot", errors.empty() ? "is not a URDF" : errors.front());
  }
  RobotFacts facts;
  for (const auto & [name, link] : robot->links_) {
    facts.links.push_back(name);
    facts.link_poses[name] = poseInRoot(link);
    if (!link->collision_array.empty()) {
      facts.links_with_collisions.push_back({name, link->collision_array.size(), canVanish(*link)});
    }
  }
  facts.base_frame = baseFrameOf(facts.link_poses, robot->getRoot()->name);
  tinyxml2::XMLDocument document;
  document.Parse(xml.c_str(), xml.size());
  facts.transmissions = readTransmissions(*document.RootElement(), warnings);
  facts.plugin_tags = readPluginTags(*document.RootElement());
  return facts;
}

RobotFacts factsOfModel(const sdf::Model & model, const std::string & source)
{
  RobotFacts facts;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    const sdf::Link & link = *model.LinkByIndex(i);
    facts.links.push_back(link.Name());
    facts.link_poses[link.Name()] = resolvePose(link.SemanticPose(), "__model__", link.Element(), source);
  }
  facts.base_frame = baseFrameOf(facts.link_poses, facts.links.empty() ? "" : facts.links.front());
  return facts;
}

void requireAllCollisions(const RobotFacts & facts, const std::vector<Solid> & solids, const std::string & source)
{
  std::size_t expected = 0;
  for (const auto & link : facts.links_with_collisions) {
    expected += link.collisions;
  }
  if (solids.size() >= expected) {
    return;
  }
  for (const auto & link : facts.links_with_collisions) {
    if (link.can_vanish) {
      throw LoadError(
        source, "link[" + link.name + "]",
        "has a <collision> but no mass, so that Gazebo leaves it out; needed is an <inertial> with a mass above 0");
    }
  }
  throw LoadError(
    source, "robot",
    "has " + std::to_string(expected) + " <collision>, of which " + std::to_string(solids.size()) +
      " were left when converted to SDF");
}
}  // namespace f1tenth_sim2d
