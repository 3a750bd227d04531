#include "f1tenth_sim2d/simulation.h"

#include "core/contacts/clearance.h"
#include "core/math/planar_pose.h"
#include "core/simulation/encounters.h"
#include "core/simulation/simulation_impl.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
std::string text(const Pose2 & pose)
{
  return "(" + toText(pose.x) + ", " + toText(pose.y) + ", " + toText(pose.yaw) + ")";
}
}  // namespace

Simulation::Simulation(const PreparedWorld & world, const SimulationOptions & options)
: impl_(std::make_unique<Impl>(world.geometry_, options))
{
}

Simulation::Simulation(const WorldDescription & world, const SimulationOptions & options)
: Simulation(PreparedWorld(world), options)
{
}

Simulation::Simulation(const Snapshot & snapshot) : impl_(std::make_unique<Impl>(*snapshot.impl_)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation &&) noexcept = default;
Simulation & Simulation::operator=(Simulation &&) noexcept = default;

CarId Simulation::addCar(const CarDescription & description, const VehicleParameters & parameters, const Pose2 & pose)
{
  validate(description, pose);
  validate(parameters, description.name);
  impl_->refuseTakenName(description.name);
  const CarId id = impl_->registry.nextId();
  auto car = std::make_unique<RegisteredCar>(
    id, impl_->registry.freeNoiseStream(), description, parameters, pose, impl_->options.seed,
    impl_->geometry->pieces());
  car->car.restart(impl_->time);
  std::vector<PlacedCar> places = placedCars(impl_->cars());
  places.push_back(car->placed());
  impl_->refuseOccupiedPlace(places, impl_->cars().size(), description.name + ": the start pose " + text(pose));
  impl_->letIn(std::move(car));
  return id;
}

void Simulation::removeCar(CarId id)
{
  impl_->registry.indexOf(id);
  const std::vector<ModelMotion> motions = impl_->collisions->motions();
  auto collisions = impl_->emptyCollisions();
  impl_->registry.remove(id);
  impl_->forgetScenes();
  impl_->enter(std::move(collisions));
  impl_->collisions->setMotions(motions);
}

void Simulation::placeCar(CarId id, const Pose2 & pose, const Vec2 & velocity, double yaw_rate)
{
  const std::size_t index = impl_->registry.indexOf(id);
  RegisteredCar & own = *impl_->cars()[index];
  validate(own.description, pose);
  validate(ModelState{pose, velocity, yaw_rate}, own.description.name);
  std::vector<PlacedCar> places = placedCars(impl_->cars());
  places[index].pose = chain(pose, {own.car.parameters().l_r, 0.0, 0.0});
  impl_->refuseOccupiedPlace(places, index, own.description.name + ": the pose " + text(pose));
  own.car.place(pose, velocity, yaw_rate);
  forgetSurroundings(impl_->cars());
}

const std::vector<CarId> & Simulation::cars() const
{
  return impl_->registry.ids();
}

const CarDescription & Simulation::car(CarId car) const
{
  return impl_->car(car).description;
}

const VehicleParameters & Simulation::parameters(CarId car) const
{
  return impl_->car(car).car.parameters();
}

SimTime Simulation::time() const
{
  return impl_->time;
}

SimTime Simulation::stepLength() const
{
  return impl_->step_length;
}

const std::vector<std::shared_ptr<Component>> & Simulation::components(CarId car) const
{
  return impl_->car(car).components;
}

void Simulation::mount(CarId car, std::shared_ptr<Component> component)
{
  impl_->car(car).mount(std::move(component));
}

void Simulation::step()
{
  for (const auto & car : impl_->cars()) {
    for (Component * component : car->acting) {
      component->beforeStep(*this, car->id);
    }
  }
  for (const auto & car : impl_->cars()) {
    car->car.predict(impl_->time, impl_->dt);
  }
  const bool touched = applyContacts(impl_->cars(), *impl_->collisions, impl_->dt, impl_->options.spares_far_cars);
  if (touched) {
    impl_->logContacts();
  }
  impl_->time += impl_->step_length;
  for (const auto & car : impl_->cars()) {
    car->car.commit(impl_->time, impl_->dt);
  }
  for (const auto & car : impl_->cars()) {
    for (Component * component : car->acting) {
      component->afterStep(*this, car->id);
    }
  }
}

void Simulation::advanceTo(SimTime end)
{
  while (impl_->time < end) {
    step();
  }
}

void Simulation::reset()
{
  impl_->time = 0;
  resetPoses();
}

void Simulation::resetPoses()
{
  impl_->returnModels();
  for (const auto & car : impl_->cars()) {
    car->car.restart(impl_->time);
    car->contacts.clear();
    for (const auto & component : car->components) {
      component->restart();
    }
  }
  // The same calls in the same order as when built anew, so that Box2D's internal order is the same, too.
  if (impl_->collisions->isPristine()) {
    forgetSurroundings(impl_->cars());
  } else {
    impl_->enter(impl_->emptyCollisions());
  }
}

void Simulation::command(CarId car, const DriveCommand & command)
{
  RegisteredCar & driven = impl_->car(car);
  validate(command, driven.description.name);
  driven.car.command(command, impl_->time);
}

void Simulation::commandTwist(CarId car, double linear_x, double angular_z, double linear_y)
{
  RegisteredCar & driven = impl_->car(car);
  validateTwist({linear_x, linear_y}, angular_z, driven.description.name);
  driven.car.command(TwistCommand{{linear_x, linear_y}, angular_z}, impl_->time);
}

Simulation::Snapshot Simulation::snapshot()
{
  Snapshot snapshot;
  snapshot.impl_ = std::make_shared<const Impl>(*impl_);
  impl_->renewCollisions(*impl_->collisions);
  return snapshot;
}

CarState Simulation::state(CarId car) const
{
  return impl_->car(car).car.state();
}

const std::vector<Contact> & Simulation::contacts(CarId car) const
{
  return impl_->car(car).contacts.contacts();
}

void Simulation::clearContacts(CarId car)
{
  impl_->car(car).contacts.clear();
}

double Simulation::clearance(CarId car, double limit) const
{
  validateClearanceLimit(limit, impl_->car(car).description.name);
  const CarRegistry & registry = impl_->registry;
  return f1tenth_sim2d::clearance(placedCars(registry.cars()), registry.indexOf(car), *impl_->collisions, limit);
}

const WorldDescription & Simulation::world() const
{
  return impl_->world();
}

void Simulation::appendStateBytes(std::vector<std::uint8_t> & bytes) const
{
  for (const auto & car : impl_->registry.cars()) {
    const BodyState & s = car->car.dynamicState();
    const double values[]{s.x, s.y, s.delta, s.v, s.psi, s.psi_dot, s.beta};
    // In the byte order of the machine, which is little-endian.
    const auto * const first = reinterpret_cast<const std::uint8_t *>(values);
    bytes.insert(bytes.end(), first, first + sizeof(values));
  }
}
}  // namespace f1tenth_sim2d
