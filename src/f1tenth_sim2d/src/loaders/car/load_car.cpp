#include <algorithm>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "loaders/car/car_mechanism.h"
#include "loaders/car/car_readers.h"
#include "loaders/model/car_context.h"
#include "loaders/model/model_reader.h"
#include "loaders/sensors/sensor_readers.h"

namespace f1tenth_sim2d
{
namespace
{
/// The link that stands for the car.
std::string baseFrameOf(const Model & model)
{
  for (const char * const name : {"base_footprint", "base_link"}) {
    if (model.link_poses.count(name) > 0) {
      return name;
    }
  }
  return model.root_link;
}

void readCarSolids(CarContext & context)
{
  for (const LinkPart & link : context.model.links) {
    for (Solid solid : link.solids) {
      solid.name = context.car.name + "::" + link.name + "::" + solid.name;
      if (std::holds_alternative<Plane>(solid.shape)) {
        link.element.fail("has the collision " + solid.name + ", a <plane>: it has no end and cannot be part of a car");
      }
      solid.pose = context.inCar(solid.pose);
      context.car.solids.push_back(std::move(solid));
    }
  }
}

/// A car that passes through everything would never collide, whatever its planner does.
void requireBody(const CarContext & context)
{
  if (context.car.solids.empty()) {
    context.model.element.fail("has nothing that could touch anything: no <collision> on a link with mass");
  }
}

/// Moves the car's frame to below the middle of the rear axle, and with it what has been read so far.
void placeFrame(CarContext & context)
{
  const Pose3 offset = properFrame(findMechanism(context));
  if (offset != Pose3()) {
    context.car_in_model = context.car_in_model * offset;
    for (Solid & solid : context.car.solids) {
      solid.pose = offset.inverse() * solid.pose;
    }
  }
  context.car.base_frame_pose = offset.inverse();
  context.car.model_pose = context.car_in_model.inverse();
  for (const auto & [link, pose] : context.model.link_poses) {
    context.car.links.push_back(link);
    context.car.link_poses[link] = context.inCar(pose);
  }
}

/// The joints between a link and the body of the car, from the body outwards.
std::vector<Hinge> hingesOf(std::string link, const CarContext & context)
{
  std::vector<Hinge> hinges;
  // Every joint once: a description may have a loop of them.
  for (std::size_t i = 0; i < context.model.joints.size(); ++i) {
    const auto & joints = context.model.joints;
    const auto joint = std::find_if(joints.begin(), joints.end(), [&](const JointPart & j) { return j.child == link; });
    if (joint == joints.end()) {
      break;
    }
    const auto & known = context.car.mechanism;
    const auto turns = [&](const JointDescription & each) { return each.name == joint->name; };
    if (const auto found = std::find_if(known.begin(), known.end(), turns); found != known.end()) {
      const Eigen::Vector3d axis = context.car_in_model.rotation.conjugate() * joint->axis.normalized();
      hinges.insert(
        hinges.begin(), {static_cast<std::size_t>(found - known.begin()), context.inCar(joint->pose).position, axis});
    }
    link = joint->parent;
  }
  return hinges;
}

void readCarVisuals(CarContext & context)
{
  for (const LinkPart & link : context.model.links) {
    const std::vector<Hinge> hinges = hingesOf(link.name, context);
    for (const Visual & visual : link.visuals) {
      context.car.visuals.push_back({context.inCar(visual.pose), hinges, visual.look});
    }
  }
}

void readParts(CarContext & context)
{
  readCarSolids(context);
  placeFrame(context);
  const std::vector<MechanismJoint> mechanism = findMechanism(context);
  readMechanism(mechanism, context.car);
  readCarVisuals(context);
  warnOfOtherJoints(mechanism, context);
  readSensors(context);
  readPlugins(mechanism, context);
  readDynamics(mechanism, context);
  requireBody(context);
}

Model readRobot(ModelReader & reader, const std::string & xml, const std::string & source)
{
  try {
    return flattened(reader.readText(xml, source, "robot description"));
  } catch (const LoadError & error) {
    if (xml.find("<xacro:") == std::string::npos) {
      throw;
    }
    throw LoadError(error.what(), "", "the description holds <xacro:…> tags; expand it with xacro first");
  }
}
}  // namespace

CarDescription loadCar(
  const std::string & xml, const std::string & name, const std::string & source, const SearchPath & search_path,
  const std::optional<std::string> & ros_namespace)
{
  const UriLookup uris(search_path, "");
  WarningCollector warnings;
  ModelReader reader(uris, warnings);
  const Model model = readRobot(reader, xml, source);
  CarDescription car;
  car.name = name;
  car.ros_namespace = ros_namespace.value_or(name);
  car.source = source;
  car.own_pose = ownPose(model);
  car.base_frame = baseFrameOf(model);
  const auto base = model.link_poses.find(car.base_frame);
  CarContext context{model, base == model.link_poses.end() ? Pose3() : base->second, car, warnings};
  readParts(context);
  car.warnings = warnings.messages();
  return car;
}
}  // namespace f1tenth_sim2d
