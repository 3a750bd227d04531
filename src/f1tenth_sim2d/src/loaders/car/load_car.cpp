#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "loaders/car/car_context.h"
#include "loaders/car/car_dynamics.h"
#include "loaders/car/car_mechanism.h"
#include "loaders/car/car_plugins.h"
#include "loaders/car/car_sensors.h"
#include "loaders/car/robot_text.h"
#include "loaders/sdf/sdf_errors.h"
#include "loaders/sdf/sdf_models.h"
#include "loaders/sdf/sdf_schema.h"

namespace f1tenth_sim2d
{
namespace
{

const sdf::Model & onlyModel(const sdf::Root & root, const std::string & source)
{
  const sdf::Model * const model = root.Model();
  if (!model) {
    throw LoadError(source, "", "holds no <model>");
  }
  if (model->ModelCount() > 0) {
    throw LoadError(source, elementPath(model->ModelByIndex(0)->Element()), "a model nested in a car is not supported");
  }
  return *model;
}

void readCarSolids(CarContext & context, const SearchPath & search_path)
{
  const UriLookup uris(search_path, "");
  MeshLibrary meshes(uris, context.warnings);
  context.car.solids = readSolids(context.model, context.car.name, context.source(), meshes);
  for (Solid & solid : context.car.solids) {
    if (std::holds_alternative<Plane>(solid.shape)) {
      throw LoadError(context.source(), solid.name, "a <plane> has no end and cannot be part of a car");
    }
    solid.pose = context.inCar(solid.pose);
  }
}

/// Moves the car's frame to below the middle of the rear axle, and what has been read so far with it.
void placeFrame(CarContext & context)
{
  const Pose3 offset = properFrame(findMechanism(context));
  if (offset != Pose3()) {
    context.car_in_model = context.car_in_model * offset;
    for (Solid & solid : context.car.solids) {
      solid.pose = offset.inverse() * solid.pose;
    }
  }
  context.car.base_frame = context.facts.base_frame;
  context.car.base_frame_pose = offset.inverse();
  context.car.model_pose = context.car_in_model.inverse();
  for (const auto & [link, pose] : context.facts.link_poses) {
    context.car.link_poses[link] = context.inCar(pose);
  }
}

void readParts(CarContext & context)
{
  placeFrame(context);
  const std::vector<MechanismJoint> mechanism = findMechanism(context);
  readMechanism(mechanism, context.car);
  readSensors(context);
  readPlugins(mechanism, context);
  readDynamics(mechanism, context);
}

CarDescription readCar(
  const std::string & xml, const std::string & name, const std::string & source, const SearchPath & search_path,
  const std::string & ros_namespace)
{
  const SdfMessages messages;
  const std::string kind = rootElement(xml, source);
  if (kind != "robot" && kind != "sdf") {
    throw LoadError(source, kind, "is no robot description, allowed are <robot> (URDF) and <sdf>");
  }
  WarningCollector warnings;
  RobotFacts facts;
  if (kind == "robot") {
    facts = readUrdf(xml, source, messages, warnings);
  }
  sdf::Root root;
  const sdf::Errors errors = loadText(xml, parserConfig(), root);
  checkSdfErrors(errors, messages, root, source, "", warnings);
  const sdf::Model & model = onlyModel(root, source);
  if (kind == "sdf") {
    facts = factsOfModel(model, source);
  }

  CarDescription car;
  car.name = name;
  car.ros_namespace = ros_namespace;
  car.source = source;
  car.links = facts.links;
  CarContext context{model, facts, facts.link_poses[facts.base_frame], car, warnings};
  readCarSolids(context, search_path);
  requireAllCollisions(facts, car.solids, source);
  readParts(context);
  car.warnings = warnings.messages();
  return car;
}
}  // namespace

CarDescription loadCar(
  const std::string & xml, const std::string & name, const std::string & source, const SearchPath & search_path,
  const std::optional<std::string> & ros_namespace)
{
  return withLoadErrors(source, [&] { return readCar(xml, name, source, search_path, ros_namespace.value_or(name)); });
}
}  // namespace f1tenth_sim2d
