#pragma once

#include <class_loader/class_loader.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/plugin.h"

namespace f1tenth_sim2d
{
/// Folders in which plugin libraries are looked up: those of LD_LIBRARY_PATH, then `lib` of every prefix of
/// CMAKE_PREFIX_PATH.
std::vector<std::string> pluginFoldersFromEnvironment();

/// Loads the shared libraries that robot descriptions name and makes the plugins in them.
class PluginHost
{
public:
  explicit PluginHost(std::vector<std::string> folders) : folders_(std::move(folders)) {}

  /// The plugin of an element, loaded with its parameters; null, after one warning, if there is no such library or no
  /// plugin for this simulator in it.
  /// @throws Error if the library cannot be loaded or the plugin refuses its parameters
  std::shared_ptr<CarPlugin> make(const PluginElement & element, const CarPluginContext & context);

private:
  std::optional<std::string> find(const std::string & filename) const;
  class_loader::ClassLoader & library(const std::string & path, const PluginElement & element);

  const std::vector<std::string> folders_;
  std::map<std::string, std::unique_ptr<class_loader::ClassLoader>> libraries_;
};
}  // namespace f1tenth_sim2d
