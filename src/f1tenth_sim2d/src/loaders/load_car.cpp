#include <sdf/Link.hh>

#include "car_context.h"
#include "car_joints.h"
#include "car_sensors.h"
#include "element_reader.h"
#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "robot_text.h"
#include "sdf_errors.h"
#include "sdf_models.h"
#include "sensor_readers.h"

namespace f1tenth_sim2d
{
namespace
{
using ignition::math::Pose3d;

/// What is known of an SDF model without converting it.
UrdfFacts factsOfModel(const sdf::Model & model, const std::string & source)
{
  const sdf::Link * const base = model.LinkByName("base_footprint");
  if (!base) {
    throw LoadError(
      source, elementPath(model.Element()),
      "has no link base_footprint, the one on the ground below the middle of the rear axle");
  }
  UrdfFacts facts;
  facts.base_footprint = resolvePose(base->SemanticPose(), "__model__", base->Element(), source);
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    facts.links.push_back(model.LinkByIndex(i)->Name());
  }
  return facts;
}

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
    solid.pose = context.inBase(solid.pose);
  }
}

/// Plugins that are built in are read; the others are kept, to be looked up as shared libraries.
void readPluginsAndJoints(CarContext & context)
{
  std::vector<sdf::ElementPtr> publishers;
  for (auto element = context.model.Element()->FindElement("plugin"); element;
       element = element->GetNextElement("plugin")) {
    const std::string library = libraryName(element);
    if (library == "libgazebo_ros_joint_state_publisher.so") {
      publishers.push_back(element);
    } else if (library == "libgazebo_ros_imu.so") {
      readImuPlugin(element, context);
    } else {
      context.car.plugins.push_back(readPlugin(element));
    }
  }
  readJoints(publishers, context);
}
}  // namespace

CarDescription loadCar(
  const std::string & xml, const std::string & name, const std::string & source, const SearchPath & search_path)
{
  const SdfMessages messages;
  const std::string kind = rootElement(xml, source);
  if (kind != "robot" && kind != "sdf") {
    throw LoadError(source, kind, "is no robot description, allowed are <robot> (URDF) and <sdf>");
  }
  const bool is_urdf = kind == "robot";
  UrdfFacts facts = is_urdf ? readUrdf(xml, source, messages) : UrdfFacts{};
  WarningCollector warnings;
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(xml, parserConfig());
  checkSdfErrors(errors, messages, root, source, "", warnings);
  const sdf::Model & model = onlyModel(root, source);
  if (!is_urdf) {
    facts = factsOfModel(model, source);
  }

  CarDescription car;
  car.name = name;
  car.source = source;
  car.links = facts.links;
  CarContext context{model, facts.base_footprint, car, warnings};
  readCarSolids(context, search_path);
  requireAllCollisions(facts, car.solids, source);
  readSensors(context);
  readPluginsAndJoints(context);
  car.warnings = warnings.messages();
  return car;
}
}  // namespace f1tenth_sim2d
