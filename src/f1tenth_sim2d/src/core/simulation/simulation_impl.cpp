#include "core/simulation/simulation_impl.h"

#include <algorithm>

#include "core/contacts/clearance.h"
#include "core/math/planar_pose.h"
#include "core/simulation/encounters.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
/// "walls::Wall_3" of "walls::Wall_3::Wall_3_Collision": the name by which a person knows the solid.
std::string withoutCollision(const std::string & scoped_name)
{
  const std::size_t end = scoped_name.rfind("::");
  return end == std::string::npos ? scoped_name : scoped_name.substr(0, end);
}
}  // namespace

Simulation::Impl::Impl(std::shared_ptr<const WorldGeometry> world, const SimulationOptions & wanted)
: geometry(std::move(world)),
  options(validated(wanted)),
  step_length(fromSeconds(options.physics_step)),
  dt(toSeconds(step_length)),
  collisions(std::make_unique<CollisionWorld>(geometry->world(), geometry->pieces()))
{
  for (const ModelDescription & model : geometry->world().models) {
    start_poses.push_back(model.pose);
  }
}

Simulation::Impl::Impl(const Impl & other)
: geometry(other.geometry),
  options(other.options),
  step_length(other.step_length),
  dt(other.dt),
  time(other.time),
  start_poses(other.start_poses),
  models_moved(other.models_moved),
  registry(other.registry)
{
  renewCollisions(*other.collisions);
}

void Simulation::Impl::letIn(std::unique_ptr<RegisteredCar> car)
{
  registry.reserve();
  collisions->prepareFor(*car->body);
  // Nothing fails from here on, so that a car is added completely or not at all.
  collisions->add(*car->body);
  forgetScenes();
  registry.add(std::move(car));
}

void Simulation::Impl::refuseTakenName(const std::string & name) const
{
  for (const auto & car : cars()) {
    if (car->description.name == name) {
      throw Error(name + ": there is already a car of this name");
    }
  }
  for (const ModelDescription & model : world().models) {
    if (model.name == name) {
      throw Error(name + ": there is already a model of this name");
    }
  }
}

// Another world around the cars; they and the models that have motions stay where they are.
void Simulation::Impl::changeWorld(WorldDescription world, const std::vector<ModelMotion> & motions)
{
  auto new_geometry = std::make_shared<const WorldGeometry>(std::move(world));
  auto new_collisions = std::make_unique<CollisionWorld>(new_geometry->world(), new_geometry->pieces());
  std::vector<std::unique_ptr<CarBody>> bodies;
  for (const auto & car : cars()) {
    bodies.push_back(car->makeBody(new_geometry->pieces()));
    new_collisions->prepareFor(*bodies.back());
  }
  // Nothing fails from here on.
  for (std::size_t i = 0; i < cars().size(); ++i) {
    cars()[i]->body.swap(bodies[i]);
  }
  forgetScenes();
  enter(std::move(new_collisions));
  collisions->setMotions(motions);
  geometry = std::move(new_geometry);
}

std::unique_ptr<CollisionWorld> Simulation::Impl::emptyCollisions() const
{
  auto empty = std::make_unique<CollisionWorld>(geometry->world(), geometry->pieces());
  for (const auto & car : cars()) {
    empty->prepareFor(*car->body);
  }
  return empty;
}

void Simulation::Impl::enter(std::unique_ptr<CollisionWorld> entered) noexcept
{
  collisions = std::move(entered);
  for (const auto & car : cars()) {
    collisions->add(*car->body);
  }
  forgetSurroundings(cars());
}

void Simulation::Impl::renewCollisions(const CollisionWorld & other)
{
  const bool is_pristine = other.isPristine();
  const std::vector<ModelMotion> motions = is_pristine ? std::vector<ModelMotion>() : other.motions();
  enter(emptyCollisions());
  collisions->setMotions(motions);
}

void Simulation::Impl::returnModels()
{
  if (!models_moved) {
    return;
  }
  WorldDescription changed = world();
  for (std::size_t i = 0; i < changed.models.size(); ++i) {
    changed.models[i].pose = start_poses[i];
  }
  changeWorld(std::move(changed), {});
  models_moved = false;
}

void Simulation::Impl::refuseOccupiedPlace(
  const std::vector<PlacedCar> & places, std::size_t own, const std::string & what) const
{
  if (const Piece * piece = firstOverlap(places, own, *collisions)) {
    throw OccupiedPlace(what + " is not free: it overlaps " + nameOf(*piece));
  }
}

std::string Simulation::Impl::nameOf(const Piece & piece) const
{
  if (piece.owner == Piece::Owner::kCar) {
    return "car " + car(CarId{piece.body}).description.name;
  }
  return "model " + withoutCollision(world().models[piece.body].solids[piece.solid].name);
}

const LidarScene & Simulation::Impl::sceneAt(double height) const
{
  const std::lock_guard<std::mutex> lock(scenes_mutex);
  const auto found =
    std::find_if(scenes.begin(), scenes.end(), [&](const LidarScene & scene) { return scene.height() == height; });
  if (found != scenes.end()) {
    return *found;
  }
  LidarScene scene(geometry->sectionAt(height));
  for (const auto & car : cars()) {
    scene.addCar(car->id, car->description.solids);
  }
  return scenes.emplace_back(std::move(scene));
}

void Simulation::Impl::logContacts()
{
  for (const auto & car : cars()) {
    const auto describe_of = [&](const StepContact & step, Contact & report) { describe(*car, step, report); };
    ContactLog of_step;
    for (const StepContact & contact : car->body->contacts) {
      car->contacts.add(contact, dt, describe_of);
      of_step.add(contact, dt, describe_of);
    }
    for (Component * component : car->acting) {
      for (const Contact & contact : of_step.contacts()) {
        component->onContact(contact);
      }
    }
  }
}

void Simulation::Impl::describe(const RegisteredCar & own, const StepContact & step, Contact & contact) const
{
  const bool is_car = step.other_owner == Piece::Owner::kCar;
  const CarDescription * other_car = is_car ? &car(CarId{step.other_body}).description : nullptr;
  const ModelDescription * model = is_car ? nullptr : &world().models[step.other_body];
  const std::vector<Solid> & solids = is_car ? other_car->solids : model->solids;
  contact.own_collision = own.description.solids[step.own_solid].name;
  contact.other_collision = solids[step.other_solid].name;
  contact.other_model = is_car ? other_car->name : model->name;
}

Pose2 Simulation::Impl::ofModel(std::size_t model) const
{
  return collisions->modelPose(model);
}

Pose2 Simulation::Impl::ofCar(CarId id) const
{
  return car(id).car.pose();
}
}  // namespace f1tenth_sim2d
