#include "node/cars/plugin_host.h"

#include <ros/console.h>

#include <filesystem>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"

namespace f1tenth_sim2d
{
std::vector<std::string> pluginFoldersFromEnvironment()
{
  std::vector<std::string> folders = pathListFromEnvironment("LD_LIBRARY_PATH");
  for (const auto & prefix : pathListFromEnvironment("CMAKE_PREFIX_PATH")) {
    folders.push_back(prefix + "/lib");
  }
  return folders;
}

std::optional<std::string> PluginHost::find(const std::string & filename) const
{
  for (const auto & folder : folders_) {
    // An absolute filename replaces the folder.
    const std::filesystem::path path = std::filesystem::path(folder) / filename;
    if (std::filesystem::is_regular_file(path)) {
      return path.string();
    }
  }
  return std::nullopt;
}

class_loader::ClassLoader & PluginHost::library(const std::string & path, const PluginElement & element)
{
  auto & loader = libraries_[path];
  if (!loader) {
    try {
      loader = std::make_unique<class_loader::ClassLoader>(path);
    } catch (const class_loader::LibraryLoadException & error) {
      throw Error(element.place + ": cannot load " + path + ": " + error.what());
    }
  }
  return *loader;
}

std::shared_ptr<CarPlugin> PluginHost::make(const PluginElement & element, const CarPluginContext & context)
{
  const auto path = find(element.filename);
  if (!path) {
    ROS_WARN(
      "%s: no plugin library %s in the lib folders of CMAKE_PREFIX_PATH and LD_LIBRARY_PATH; left out",
      element.place.c_str(), element.filename.c_str());
    return nullptr;
  }
  auto & loader = library(*path, element);
  const auto classes = loader.getAvailableClasses<CarPlugin>();
  if (classes.empty()) {
    ROS_WARN("%s: %s has no plugin for this simulator; left out", element.place.c_str(), path->c_str());
    return nullptr;
  }
  auto plugin = loader.createInstance<CarPlugin>(classes.front());
  plugin->load(element, context);
  return plugin;
}
}  // namespace f1tenth_sim2d
