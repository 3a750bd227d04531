#include "loaders/sdf/sdf_models.h"

#include <sdf/Collision.hh>
#include <sdf/Joint.hh>
#include <sdf/Link.hh>

#include "f1tenth_sim2d/errors.h"
#include "loaders/sdf/element_reader.h"
#include "loaders/sdf/from_ignition.h"
#include "loaders/sdf/sdf_shapes.h"

namespace f1tenth_sim2d
{
namespace
{
const char * const kModelFrame = "__model__";

Pose3 linkPose(const sdf::Link & link, const std::string & file)
{
  return resolvePose(link.SemanticPose(), kModelFrame, link.Element(), file);
}

void readInertia(const sdf::Model & model, const std::string & file, ModelDescription & description)
{
  const Inertia whole = inertiaOf(model, file);
  ElementReader(model.Element(), file).requireNear(whole.centre_of_mass);
  description.mass = whole.mass;
  description.inertia_zz = whole.about_z;
  description.centre_of_mass = {whole.centre_of_mass.x(), whole.centre_of_mass.y()};
}

/// Children that have no counterpart in the simulation, each with the reason.
void warnOfChildren(const sdf::ElementPtr & parent, WarningCollector & warnings)
{
  static const std::vector<std::pair<std::string, std::string>> left_out = {
    {"sensor", "<sensor> is left out: only cars have sensors"},
    {"plugin", "<plugin> of a model is left out: only cars have plugins"},
    {"gripper", "<gripper> is left out"},
    {"audio_source", "<audio_source> is left out"},
    {"audio_sink", "<audio_sink> is left out"},
    {"battery", "<battery> is left out"},
    {"projector", "<projector> is left out"},
    {"particle_emitter", "<particle_emitter> is left out"},
  };
  for (auto child = parent->GetFirstElement(); child; child = child->GetNextElement()) {
    for (const auto & [tag, reason] : left_out) {
      if (child->GetName() == tag) {
        warnings.add(reason, elementPath(child));
      }
    }
  }
}

void warnOfModel(const sdf::Model & model, WarningCollector & warnings)
{
  warnOfChildren(model.Element(), warnings);
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    warnOfChildren(model.LinkByIndex(i)->Element(), warnings);
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    if (!model.Static() && model.JointByIndex(i)->Type() != sdf::JointType::FIXED) {
      warnings.add("<joint> does not move: a model is one rigid body", elementPath(model.JointByIndex(i)->Element()));
    }
  }
}

void appendModel(
  const sdf::Model & model, const Pose3 & pose, const std::string & scope, bool is_static, const std::string & file,
  MeshLibrary & meshes, std::vector<ModelDescription> & models, WarningCollector & warnings)
{
  warnOfModel(model, warnings);
  ElementReader(model.Element(), file).requireNear(pose.position);
  ModelDescription description;
  description.name = scope + model.Name();
  description.pose = pose;
  description.is_static = is_static || model.Static();
  const std::string inner_scope = description.name + "::";
  if (model.LinkCount() > 0) {
    description.solids = readSolids(model, description.name, file, meshes);
    readInertia(model, file, description);
    models.push_back(description);
  }
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
    const sdf::Model & nested = *model.ModelByIndex(i);
    const Pose3 nested_pose = pose * resolvePose(nested.SemanticPose(), kModelFrame, nested.Element(), file);
    appendModel(nested, nested_pose, inner_scope, description.is_static, file, meshes, models, warnings);
  }
}

void appendParameters(const sdf::ElementPtr & parent, const std::string & scope, PluginElement & plugin)
{
  for (auto child = parent->GetFirstElement(); child; child = child->GetNextElement()) {
    const std::string tag = scope + child->GetName();
    plugin.parameters.emplace_back(tag, child->GetValue() ? child->GetValue()->GetAsString() : "");
    appendParameters(child, tag + "/", plugin);
  }
}
}  // namespace

Inertia inertiaOf(const sdf::Model & model, const std::string & file)
{
  using ignition::math::Inertiald;
  Inertiald sum;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    const sdf::Link & link = *model.LinkByIndex(i);
    const Inertiald & own = link.Inertial();
    const Pose3 place = linkPose(link, file);
    const ignition::math::Pose3d link_pose(
      place.position.x(), place.position.y(), place.position.z(), place.rotation.w(), place.rotation.x(),
      place.rotation.y(), place.rotation.z());
    const Inertiald in_model(own.MassMatrix(), link_pose * own.Pose());
    sum = i == 0 ? in_model : sum + in_model;
  }
  return {sum.MassMatrix().Mass(), fromIgnition(sum.Pose().Pos()), sum.Moi()(2, 2)};
}

Pose3 resolvePose(
  const sdf::SemanticPose & pose, const std::string & frame, const sdf::ElementPtr & element, const std::string & file)
{
  ignition::math::Pose3d resolved;
  if (const sdf::Errors errors = pose.Resolve(resolved, frame); !errors.empty()) {
    throw LoadError(file, elementPath(element), errors.front().Message());
  }
  return fromIgnition(resolved);
}

std::vector<Solid> readSolids(
  const sdf::Model & model, const std::string & scope, const std::string & file, MeshLibrary & meshes)
{
  std::vector<Solid> solids;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    const sdf::Link & link = *model.LinkByIndex(i);
    const Pose3 link_pose = linkPose(link, file);
    for (std::uint64_t k = 0; k < link.CollisionCount(); ++k) {
      const sdf::Collision & collision = *link.CollisionByIndex(k);
      Solid solid = readCollision(collision, scope + "::" + link.Name() + "::" + collision.Name(), file, meshes);
      solid.pose = link_pose * resolvePose(collision.SemanticPose(), "", collision.Element(), file) * solid.pose;
      ElementReader(collision.Element(), file).requireNear(solid.pose.position);
      solids.push_back(std::move(solid));
    }
  }
  return solids;
}

void appendModel(
  const sdf::Model & model, const Pose3 & pose, const std::string & file, MeshLibrary & meshes,
  std::vector<ModelDescription> & models, WarningCollector & warnings)
{
  appendModel(model, pose, "", false, file, meshes, models, warnings);
}

PluginElement readPlugin(const sdf::ElementPtr & element)
{
  PluginElement plugin;
  plugin.name = element->Get<std::string>("name");
  plugin.filename = element->Get<std::string>("filename");
  plugin.place = elementPath(element);
  appendParameters(element, "", plugin);
  return plugin;
}
}  // namespace f1tenth_sim2d
