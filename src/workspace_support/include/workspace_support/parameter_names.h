#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace workspace_support
{
/// What one parameter may be called; of those that are set the first counts. A name may be a path into nested maps,
/// "global_costmap/footprint".
struct ParameterNames
{
  ParameterNames(const char * name) : current{name} {}
  ParameterNames(std::string name) : current{std::move(name)} {}
  ParameterNames(std::vector<std::string> names) : current(std::move(names)) {}
  ParameterNames(std::initializer_list<std::string> names) : current(names) {}

  /// The same, also known by a name that it had before: that one warns.
  ParameterNames formerly(std::string name) const
  {
    ParameterNames names = *this;
    names.deprecated.push_back(std::move(name));
    return names;
  }

  std::vector<std::string> current;
  std::vector<std::string> deprecated;
};
}  // namespace workspace_support
