#include "loaders/sensors/contact_sensor.h"

#include <algorithm>

namespace f1tenth_sim2d
{
namespace
{
std::string lastPart(const std::string & scoped_name)
{
  const std::size_t separator = scoped_name.rfind("::");
  return separator == std::string::npos ? scoped_name : scoped_name.substr(separator + 2);
}

/// Undoes Gazebo's renaming: "base_fixed_joint_lump__bumper_collision_1" -> "bumper_collision", with the
/// number only if there is one.
std::vector<std::string> namesBeforeJoining(const std::string & name)
{
  static const std::string mark = "_fixed_joint_lump__";
  const std::size_t found = name.rfind(mark);
  if (found == std::string::npos) {
    return {};
  }
  const std::string rest = name.substr(found + mark.size());
  const std::size_t number = rest.find_last_not_of("0123456789");
  const bool numbered = number != std::string::npos && number + 1 < rest.size() && rest[number] == '_';
  return numbered ? std::vector<std::string>{rest.substr(0, number), rest} : std::vector<std::string>{rest};
}

bool isMeant(const std::string & wanted, const Solid & solid)
{
  const std::string name = lastPart(solid.name);
  const std::vector<std::string> before = namesBeforeJoining(name);
  return name == lastPart(wanted) || std::find(before.begin(), before.end(), lastPart(wanted)) != before.end();
}

std::string listed(const std::vector<Solid> & solids)
{
  std::string names;
  for (const Solid & solid : solids) {
    names += (names.empty() ? "" : ", ") + lastPart(solid.name);
  }
  return names;
}
}  // namespace

std::vector<std::string> collisionsOfContactSensor(const Element & sensor, const std::vector<Solid> & solids)
{
  const std::vector<Element> collisions = sensor.child("contact").children("collision");
  if (collisions.empty()) {
    sensor.fail("has no <contact> with a <collision>");
  }
  std::vector<std::string> names;
  for (const Element & collision : collisions) {
    const std::string wanted = collision.text();
    const auto solid =
      std::find_if(solids.begin(), solids.end(), [&wanted](const Solid & each) { return isMeant(wanted, each); });
    if (solid == solids.end()) {
      sensor.fail("there is no <collision> '" + wanted + "'; the car has " + listed(solids));
    }
    names.push_back(solid->name);
  }
  return names;
}
}  // namespace f1tenth_sim2d
