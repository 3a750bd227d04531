#include "loaders/world/describe_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
/// Least z of the normal of a plane that counts as level: within a tenth of a degree.
constexpr double kLevel = 1.0 - 1.5e-6;

bool holdsToTheWorld(const JointPart & joint)
{
  return joint.type == "fixed" && (joint.parent == "world" || joint.child == "world");
}

/// Whether a model does not move, or consists only of nested ones that do not.
bool isStatic(const Model & model)
{
  const bool only_nested = model.links.empty() && !model.models.empty();
  return model.is_static || (only_nested && std::all_of(model.models.begin(), model.models.end(), isStatic));
}

/// Whether a joint of a model holds something that is nested in it.
bool isTied(const Model & nested, const std::vector<JointPart> & joints)
{
  const std::string scope = nested.name + "::";
  return std::any_of(joints.begin(), joints.end(), [&scope](const JointPart & joint) {
    return joint.parent.rfind(scope, 0) == 0 || joint.child.rfind(scope, 0) == 0;
  });
}

bool isOneBody(const Model & model);

/// A model and those nested in it that its joints hold are one: they move together.
Model withTiedModels(Model model)
{
  if (isOneBody(model)) {
    model.is_static = isStatic(model);
    return flattened(std::move(model));
  }
  const auto is_tied = [&model](const Model & nested) { return isTied(nested, model.joints); };
  const auto first_loose = std::stable_partition(model.models.begin(), model.models.end(), is_tied);
  std::vector<Model> loose(std::make_move_iterator(first_loose), std::make_move_iterator(model.models.end()));
  model.models.erase(first_loose, model.models.end());
  model = flattened(std::move(model));
  model.models = std::move(loose);
  return model;
}

/// Whether a model consists only of nested ones that cannot move apart: a single one, or none that moves at all.
bool isOneBody(const Model & model)
{
  if (!model.links.empty() || model.models.empty()) {
    return false;
  }
  return isStatic(model) || (model.models.size() == 1 && withTiedModels(model.models.front()).models.empty());
}

void warnOfJoints(const Model & model, WarningCollector & warnings)
{
  for (const JointPart & joint : model.joints) {
    if (joint.type != "fixed") {
      warnings.add("<joint> does not move: a model is one rigid body", joint.element.fileLine());
    }
  }
}

void warnOfSensorsAndPlugins(const Model & model, WarningCollector & warnings)
{
  for (const Element & plugin : model.plugins) {
    warnings.add("<plugin> of a model is left out: only cars have plugins", plugin.fileLine());
  }
  for (const LinkPart & link : model.links) {
    for (const SensorPart & sensor : link.sensors) {
      warnings.add("<sensor> is left out: only cars have sensors", sensor.element.fileLine());
    }
  }
}

bool isUnevenPlane(const Solid & solid, const Pose3 & model)
{
  return std::holds_alternative<Plane>(solid.shape) && (model * solid.pose).up().z() < kLevel;
}

void warnOfPlanes(const Model & model, const Pose3 & pose, WarningCollector & warnings)
{
  for (const LinkPart & link : model.links) {
    for (const Solid & solid : link.solids) {
      if (isUnevenPlane(solid, pose)) {
        warnings.add("<plane> that is not level is left out: the ground is level", link.element.fileLine());
      }
    }
  }
}

std::vector<Solid> solidsOf(const Model & model, const std::string & scope)
{
  std::vector<Solid> solids;
  for (const LinkPart & link : model.links) {
    for (Solid solid : link.solids) {
      solid.name = scope + "::" + link.name + "::" + solid.name;
      solids.push_back(std::move(solid));
    }
  }
  return solids;
}

void requireAboveZero(const Element & model, const char * what, double value)
{
  if (!std::isfinite(value) || value <= 0.0) {
    model.fail(
      std::string("can be pushed, but has ") + what + " of " + toText(value) +
      "; allowed are finite numbers greater than 0, or <static>true</static>");
  }
}

/// What is left of a pose without position and heading.
Pose3 tiltOf(const Pose3 & pose)
{
  const Pose3 heading(0.0, 0.0, 0.0, 0.0, 0.0, pose.yaw());
  return {Eigen::Vector3d::Zero(), heading.rotation.conjugate() * pose.rotation};
}

/// Inertia of the model as placed: one that lies on its side turns about another axis. A static one has none.
void describeInertia(const Model & model, ModelDescription & description)
{
  const Inertia whole = placed(inertiaOf(model), tiltOf(description.pose));
  description.mass = whole.mass;
  description.inertia_zz = whole.moments(2, 2);
  description.centre_of_mass = {whole.centre.x(), whole.centre.y()};
  if (!description.is_static) {
    requireAboveZero(model.element, "a mass (kg)", whole.mass);
    requireAboveZero(model.element, "an inertia about z (kg m^2)", whole.moments(2, 2));
    model.element.requireNear(whole.centre);
  }
}

void append(
  const Model & given, const Pose3 & pose, const std::string & scope, bool is_static,
  std::vector<ModelDescription> & models, WarningCollector & warnings)
{
  const Model model = withTiedModels(given);
  if (!pose.rotation.coeffs().allFinite()) {
    model.element.fail("has a rotation that is not finite");
  }
  model.element.requireNear(pose.position);
  warnOfSensorsAndPlugins(model, warnings);
  warnOfPlanes(model, pose, warnings);
  ModelDescription description;
  description.name = scope + model.name;
  description.pose = pose;
  const bool stands = is_static || model.is_static;  // in Gazebo, too, where a joint to the world holds one link only
  if (!stands) {
    warnOfJoints(model, warnings);
  }
  description.is_static = stands || std::any_of(model.joints.begin(), model.joints.end(), holdsToTheWorld);
  if (!model.links.empty()) {
    description.solids = solidsOf(model, description.name);
    for (const LinkPart & link : model.links) {
      description.visuals.insert(description.visuals.end(), link.visuals.begin(), link.visuals.end());
    }
    describeInertia(model, description);
    models.push_back(description);
  }
  for (const Model & nested : model.models) {
    append(nested, pose * nested.pose, description.name + "::", description.is_static, models, warnings);
  }
}
}  // namespace

void appendModel(
  const Model & model, const Pose3 & pose, std::vector<ModelDescription> & models, WarningCollector & warnings)
{
  append(model, pose, "", false, models, warnings);
}
}  // namespace f1tenth_sim2d
