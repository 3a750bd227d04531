#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace workspace_support
{
/// Names that one parameter may have; the first that is set counts. A name may be a path into nested maps,
/// "global_costmap/footprint".
struct ParameterNames
{
  ParameterNames(const char * name) : current{name} {}
  ParameterNames(std::string name) : current{std::move(name)} {}
  ParameterNames(std::vector<std::string> names) : current(std::move(names)) {}
  ParameterNames(std::initializer_list<std::string> names) : current(names) {}

  std::vector<std::string> current;
};
}  // namespace workspace_support
