#include "loaders/car/car_context.h"

namespace f1tenth_sim2d
{
namespace
{
std::string withoutSlashesAround(const std::string & text)
{
  const std::size_t first = text.find_first_not_of('/');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of('/') - first + 1);
}
}  // namespace

std::string CarContext::withoutPrefix(std::string frame) const
{
  for (const std::string & prefix : {std::string("/"), car.name + "/"}) {
    if (frame.rfind(prefix, 0) == 0) {
      frame.erase(0, prefix.size());
    }
  }
  return frame;
}

std::string CarContext::rosNamespace(const sdf::ElementPtr & plugin) const
{
  const std::string given = withoutBlanksAround(plugin->Get<std::string>("robotNamespace", "").first);
  const std::string space = withoutSlashesAround(given);
  return given.empty() || space == car.ros_namespace ? "" : "/" + space;
}

std::string CarContext::topic(const sdf::ElementPtr & plugin, const std::string & name) const
{
  const std::string own = car.ros_namespace.empty() ? "/" : "/" + car.ros_namespace + "/";
  if (!name.empty() && name.front() == '/') {
    return name.rfind(own, 0) == 0 ? name.substr(own.size()) : name;
  }
  const std::string space = rosNamespace(plugin);
  return space.empty() ? name : space + (space == "/" ? "" : "/") + name;
}

std::string CarContext::originalText(
  const sdf::ElementPtr & plugin, const std::string & tag, const std::string & fallback) const
{
  const auto tags = facts.plugin_tags.find(plugin->Get<std::string>("name"));
  if (tags != facts.plugin_tags.end()) {
    const auto text = tags->second.find(tag);
    return text == tags->second.end() || text->second.empty() ? fallback : text->second;
  }
  const std::string text = withoutBlanksAround(plugin->Get<std::string>(tag, fallback).first);
  return text.empty() ? fallback : text;
}

std::string libraryName(const sdf::ElementPtr & plugin)
{
  const auto filename = plugin->Get<std::string>("filename");
  return filename.substr(filename.find_last_of('/') + 1);
}
}  // namespace f1tenth_sim2d
