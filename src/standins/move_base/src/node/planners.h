#pragma once

#include <class_loader/class_loader.hpp>

#include <map>
#include <memory>
#include <string>

#include "move_base/local_planner.h"

namespace move_base
{
/// Makes the planners that base_global_planner and base_local_planner name: PACKAGE/CLASS of a library
/// libPACKAGE_planners.so, or for the names of the original's own planners the plain ones.
class Planners
{
public:
  /// Must outlive what is made.
  Planners() = default;

  /// @throws OptionError for a class that cannot be loaded, and for parameters that cannot be used
  std::unique_ptr<GlobalPlanner> makeGlobal(const std::string & type, const PlannerSetup & setup);
  std::unique_ptr<LocalPlanner> makeLocal(const std::string & type, const PlannerSetup & setup);

private:
  template <class Plugin>
  class_loader::ClassLoader::UniquePtr<Plugin> load(
    const std::string & parameter, const std::string & type, const PlannerSetup & setup);

  std::map<std::string, std::unique_ptr<class_loader::ClassLoader>> libraries_;
};
}  // namespace move_base
