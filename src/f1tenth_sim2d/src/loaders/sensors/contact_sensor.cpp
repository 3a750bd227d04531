#include "loaders/sensors/sensor_readers.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <set>

namespace f1tenth_sim2d
{
namespace
{
using boost::algorithm::join;

const std::string kScopeSeparator = "::";

/// A name and what stands in front of it: the model, if it is named, and the link.
struct ScopedName
{
  std::string scope;
  std::string name;
};

ScopedName splitName(const std::string & text)
{
  const std::size_t separator = text.rfind(kScopeSeparator);
  return separator == std::string::npos
           ? ScopedName{"", text}
           : ScopedName{text.substr(0, separator), text.substr(separator + kScopeSeparator.size())};
}

/// The link that a solid of the car belongs to.
std::string linkOf(const Solid & solid, const CarContext & context)
{
  return splitName(solid.name).scope.substr(context.car.name.size() + kScopeSeparator.size());
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

bool isCalled(const Solid & solid, const std::string & wanted)
{
  const std::string name = splitName(solid.name).name;
  const std::vector<std::string> before = namesBeforeJoining(name);
  return name == wanted || std::find(before.begin(), before.end(), wanted) != before.end();
}

/// The link that a scope means; it may begin with the car's name, or with the one that its description has.
std::string linkOfScope(const std::string & scope, const CarContext & context)
{
  for (const std::string & model : {context.car.name, context.model.name}) {
    if (scope.rfind(model + kScopeSeparator, 0) == 0) {
      return scope.substr(model.size() + kScopeSeparator.size());
    }
  }
  return scope;
}

/// Whether a fixed joint has made a link part of another one.
bool isJoined(const std::string & link, const CarContext & context)
{
  const auto & links = context.model.links;
  return context.model.link_poses.count(link) > 0 &&
         std::none_of(links.begin(), links.end(), [&link](const LinkPart & each) { return each.name == link; });
}

/// What a name means, by link; of several in one link the first counts.
std::vector<const Solid *> meant(const std::string & wanted, const std::string & own_link, const CarContext & context)
{
  const auto [scope, name] = splitName(wanted);
  const std::string named_link = linkOfScope(scope, context);
  const bool anywhere = scope.empty() || isJoined(named_link, context);
  std::vector<const Solid *> found;
  std::set<std::string> links;
  for (const Solid & solid : context.car.solids) {
    const std::string link = linkOf(solid, context);
    if (isCalled(solid, name) && (anywhere || link == named_link) && links.insert(link).second) {
      if (anywhere && link == own_link) {
        return {&solid};
      }
      found.push_back(&solid);
    }
  }
  return found;
}

std::vector<std::string> namesWithLink(const std::vector<const Solid *> & solids, const CarContext & context)
{
  std::vector<std::string> names;
  for (const Solid * const solid : solids) {
    names.push_back(linkOf(*solid, context) + kScopeSeparator + splitName(solid->name).name);
  }
  return names;
}
}  // namespace

std::vector<std::string> collisionsOfContactSensor(
  const Element & sensor, const std::string & link, const CarContext & context)
{
  const std::vector<Element> collisions = sensor.child("contact").children("collision");
  if (collisions.empty()) {
    sensor.fail("has no <contact> with a <collision>");
  }
  std::vector<std::string> names;
  for (const Element & collision : collisions) {
    const std::string wanted = collision.text();
    const std::vector<const Solid *> solids = meant(wanted, link, context);
    if (solids.empty()) {
      std::vector<const Solid *> all;
      for (const Solid & solid : context.car.solids) {
        all.push_back(&solid);
      }
      sensor.fail("there is no <collision> '" + wanted + "'; the car has " + join(namesWithLink(all, context), ", "));
    }
    if (solids.size() > 1) {
      sensor.fail(
        "<collision> '" + wanted + "' is in " + join(namesWithLink(solids, context), " and ") + "; write which");
    }
    names.push_back(solids.front()->name);
  }
  return names;
}
}  // namespace f1tenth_sim2d
