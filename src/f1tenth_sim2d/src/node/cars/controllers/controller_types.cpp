#include "node/cars/controllers/controller_types.h"

#include <boost/algorithm/string/join.hpp>

#include <functional>

#include "f1tenth_sim2d/errors.h"
#include "node/cars/controllers/joint_controller.h"
#include "node/cars/controllers/joint_state_controller.h"
#include "node/cars/controllers/steering_controller.h"

namespace f1tenth_sim2d
{
namespace
{
struct Type
{
  std::string name;
  std::function<std::unique_ptr<Controller>(const ControllerSetup &)> make;
};

template <class Kind>
Type plainType(const std::string & name)
{
  return {name, [](const ControllerSetup & setup) { return std::make_unique<Kind>(setup); }};
}

std::vector<Type> makeTypes()
{
  std::vector<Type> types{
    plainType<JointStateController>("joint_state_controller/JointStateController"),
    plainType<SteeringController>("ackermann_steering_controller/AckermannSteeringController"),
    plainType<SteeringController>("steer_drive_controller/SteerDriveController")};
  for (const JointControllerType & type : jointControllerTypes()) {
    types.push_back(
      {type.name, [&type](const ControllerSetup & setup) { return std::make_unique<JointController>(type, setup); }});
  }
  return types;
}

const std::vector<Type> & types()
{
  static const std::vector<Type> types = makeTypes();
  return types;
}
}  // namespace

std::vector<std::string> controllerTypes()
{
  std::vector<std::string> names;
  names.reserve(types().size());
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
