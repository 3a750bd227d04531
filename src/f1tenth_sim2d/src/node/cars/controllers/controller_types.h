#pragma once

#include <memory>
#include <string>
#include <vector>

#include "node/cars/controllers/controller.h"
#include "node/cars/controllers/controller_setup.h"

namespace f1tenth_sim2d
{
/// Names of all types of controllers.
std::vector<std::string> controllerTypes();

/// A controller of the setup's type.
/// @throws Error for an unknown type, std::runtime_error for parameters that make no sense: each names the controller
std::unique_ptr<Controller> makeController(const ControllerSetup & setup);
}  // namespace f1tenth_sim2d
