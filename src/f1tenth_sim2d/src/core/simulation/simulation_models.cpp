#include "core/math/planar_pose.h"
#include "core/simulation/encounters.h"
#include "core/simulation/simulation_impl.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
const std::vector<ModelDescription> & Simulation::models() const
{
  return world().models;
}

ModelState Simulation::modelState(std::size_t index) const
{
  return impl_->collisions->modelState(index);
}

std::size_t Simulation::indexOfModel(const std::string & model) const
{
  const std::vector<ModelDescription> & models = world().models;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].name == model) {
      return i;
    }
  }
  throw Error("there is no model " + model + " in " + world().file);
}

Pose2 Simulation::modelPose(const std::string & model) const
{
  return modelState(indexOfModel(model)).pose;
}

std::vector<std::string> Simulation::modelNames() const
{
  std::vector<std::string> names;
  for (const ModelDescription & model : world().models) {
    names.push_back(model.name);
  }
  return names;
}

void Simulation::addModel(const ModelDescription & model)
{
  impl_->refuseTakenName(model.name);
  validate(model, world().file);
  WorldDescription changed = world();
  changed.models.push_back(model);
  std::vector<ModelMotion> motions = impl_->collisions->motions();
  motions.emplace_back();
  impl_->start_poses.reserve(impl_->start_poses.size() + 1);
  impl_->changeWorld(std::move(changed), motions);
  impl_->start_poses.push_back(model.pose);
}

void Simulation::removeModel(std::size_t index)
{
  std::vector<ModelMotion> motions = impl_->collisions->motions();
  static_cast<void>(motions.at(index));  // throws before anything is changed
  const auto place = static_cast<std::ptrdiff_t>(index);
  WorldDescription changed = world();
  changed.models.erase(changed.models.begin() + place);
  motions.erase(motions.begin() + place);
  impl_->changeWorld(std::move(changed), motions);
  impl_->start_poses.erase(impl_->start_poses.begin() + place);
  for (const auto & car : impl_->cars()) {
    car->contacts.forgetModel(index);
  }
}

void Simulation::placeModel(std::size_t index, const ModelState & state, double lift)
{
  const bool is_static = world().models.at(index).is_static;
  validate(state, world().models[index].name);
  if (is_static || lift != 0.0) {
    WorldDescription changed = world();
    ModelDescription & model = changed.models[index];
    const Pose2 shadow = is_static ? state.pose : planar(model.pose);
    model.pose = Pose3(shadow.x, shadow.y, lift, 0.0, 0.0, shadow.yaw) * withoutPlanar(model.pose);
    validate(model, changed.file);
    impl_->changeWorld(std::move(changed), impl_->collisions->motions());
    impl_->models_moved = true;
  }
  if (!is_static) {
    impl_->collisions->placeModel(index, state);
    forgetSurroundings(impl_->cars());
  }
}
}  // namespace f1tenth_sim2d
