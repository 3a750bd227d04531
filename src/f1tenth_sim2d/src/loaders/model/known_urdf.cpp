#include "loaders/model/known_urdf.h"

#include <map>
#include <set>
#include <string>

namespace f1tenth_sim2d
{
namespace
{
struct Known
{
  std::set<std::string> attributes;
  std::set<std::string> children;
};

/// What URDF knows of links and joints. Elements that are not here may hold anything.
const std::map<std::string, Known> & known()
{
  static const std::map<std::string, Known> tags{
    {"robot",
     {{"name", "version", "xmlns"}, {"gazebo", "joint", "link", "material", "origin", "sensor", "transmission"}}},
    {"link", {{"name", "type"}, {"collision", "inertial", "self_collision_checking", "contact", "visual"}}},
    {"inertial", {{}, {"inertia", "mass", "origin"}}},
    {"mass", {{"value"}, {}}},
    {"inertia", {{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}, {}}},
    {"collision", {{"group", "name"}, {"contact_coefficients", "geometry", "material", "origin", "verbose"}}},
    {"geometry", {{}, {"box", "capsule", "cylinder", "mesh", "sphere"}}},
    {"box", {{"size"}, {}}},
    {"capsule", {{"length", "radius"}, {}}},
    {"cylinder", {{"length", "radius"}, {}}},
    {"mesh", {{"filename", "scale"}, {}}},
    {"sphere", {{"radius"}, {}}},
    {"origin", {{"quat_xyzw", "rpy", "xyz"}, {}}},
    {"joint",
     {{"name", "type"},
      {"axis", "calibration", "child", "dynamics", "hardwareInterface", "limit", "mimic", "origin", "parent",
       "safety_controller"}}},
    {"parent", {{"link"}, {}}},
    {"child", {{"link"}, {}}},
    {"axis", {{"xyz"}, {}}},
    {"limit", {{"acceleration", "effort", "jerk", "lower", "upper", "velocity"}, {}}},
  };
  return tags;
}

bool hasPrefix(const std::string & name)
{
  return name.find(':') != std::string::npos;
}

void walk(const Element & element, WarningCollector & warnings)
{
  const auto found = known().find(element.tag());
  if (found == known().end()) {
    return;
  }
  for (const std::string & attribute : element.attributes()) {
    if (found->second.attributes.count(attribute) == 0 && !hasPrefix(attribute)) {
      warnings.add("attribute '" + attribute + "' is none of URDF and left out", element.fileLine());
    }
  }
  for (const Element & child : element.children()) {
    if (found->second.children.count(child.tag()) > 0) {
      walk(child, warnings);
    } else if (child.tag().rfind("xacro:", 0) == 0) {
      child.fail("is not an element of URDF");  // what it stands for would be missing in silence
    } else if (!hasPrefix(child.tag())) {
      warnings.add("is not an element of URDF and left out", child.fileLine());
    }
  }
}
}  // namespace

void warnOfUnknownUrdf(const Element & robot, WarningCollector & warnings)
{
  walk(robot, warnings);
}
}  // namespace f1tenth_sim2d
