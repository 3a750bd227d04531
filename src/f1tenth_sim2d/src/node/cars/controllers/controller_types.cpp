#include "node/cars/controllers/controller_types.h"

#include <boost/algorithm/string/join.hpp>

#include <functional>

#include "f1tenth_sim2d/errors.h"
#include "node/cars/controllers/joint_controller.h"
#include "node/cars/controllers/joint_state_controller.h"

namespace f1tenth_sim2d
{
namespace
{
struct Type
{
  std::string name;
  std::function<std::unique_ptr<Controller>(const ControllerSetup &)> make;
};

template <class Made, class... Arguments>
Type type(const std::string & name, const Arguments &... arguments)
{
  return {name, [=](const ControllerSetup & setup) { return std::make_unique<Made>(setup, arguments...); }};
}

const std::vector<Type> & types()
{
  using Kind = JointCommand::Kind;
  static const std::string velocity = "hardware_interface::VelocityJointInterface";
  static const std::string position = "hardware_interface::PositionJointInterface";
  static const std::string effort = "hardware_interface::EffortJointInterface";
  static const std::vector<Type> types{
    type<JointStateController>("joint_state_controller/JointStateController"),
    type<JointController>("velocity_controllers/JointVelocityController", velocity, Kind::kVelocity),
    type<JointController>("velocity_controllers/JointPositionController", velocity, Kind::kPosition),
    type<JointController>("position_controllers/JointPositionController", position, Kind::kPosition),
    type<JointController>("effort_controllers/JointEffortController", effort, Kind::kEffort),
    type<JointController>("effort_controllers/JointVelocityController", effort, Kind::kVelocity),
    type<JointController>("effort_controllers/JointPositionController", effort, Kind::kPosition),
  };
  return types;
}
}  // namespace

std::vector<std::string> controllerTypes()
{
  std::vector<std::string> names;
  for (const Type & type : types()) {
    names.push_back(type.name);
  }
  return names;
}

std::unique_ptr<Controller> makeController(const ControllerSetup & setup)
{
  for (const Type & type : types()) {
    if (type.name == setup.type) {
      return type.make(setup);
    }
  }
  throw Error(
    "controller " + setup.name + ": type " + setup.type + " is unknown; known are " +
    boost::algorithm::join(controllerTypes(), ", "));
}
}  // namespace f1tenth_sim2d
