#include "f1tenth_sim2d/simulation.h"

#include "core/car/state_bytes.h"
#include "core/contacts/clearance.h"
#include "core/simulation/simulation_impl.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
Simulation::Simulation(const WorldDescription & world, const SimulationOptions & options)
: impl_(std::make_unique<Impl>(world, options))
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation &&) noexcept = default;
Simulation & Simulation::operator=(Simulation &&) noexcept = default;

CarIndex Simulation::addCar(const CarDescription & car, const VehicleParameters & parameters, const Pose2 & pose)
{
  return impl_->addCar(car, parameters, pose);
}

void Simulation::removeCar(CarIndex index)
{
  impl_->removeCar(index);
}

void Simulation::placeCar(CarIndex index, const Pose2 & pose, const Vec2 & velocity, double yaw_rate)
{
  impl_->placeCar(index, pose, velocity, yaw_rate);
}

std::size_t Simulation::carCount() const
{
  return impl_->cars().size();
}
const CarDescription & Simulation::car(CarIndex index) const
{
  return impl_->car(index).description();
}
const VehicleParameters & Simulation::parameters(CarIndex index) const
{
  return impl_->car(index).parameters();
}
SimTime Simulation::time() const
{
  return impl_->time();
}
SimTime Simulation::stepLength() const
{
  return impl_->stepLength();
}
void Simulation::step()
{
  impl_->step();
}
void Simulation::reset()
{
  impl_->reset();
}
void Simulation::resetPoses()
{
  impl_->resetPoses();
}

void Simulation::advanceTo(SimTime end)
{
  while (impl_->time() < end) {
    impl_->step();
  }
}

void Simulation::command(CarIndex index, const DriveCommand & command)
{
  Car & car = impl_->car(index);
  validate(command, car.description().name);
  car.command(command, impl_->time());
}

void Simulation::commandTwist(CarIndex index, double linear_x, double angular_z, double linear_y)
{
  validateTwist({linear_x, linear_y}, angular_z, car(index).name);
  impl_->car(index).commandTwist({{linear_x, linear_y}, angular_z}, impl_->time());
}

const CarState & Simulation::state(CarIndex index) const
{
  return impl_->car(index).state();
}
WheelOdometry Simulation::wheelOdometry(CarIndex index) const
{
  return impl_->car(index).wheelOdometry();
}
ImuSample Simulation::imu(CarIndex index) const
{
  return impl_->imu(index);
}

void Simulation::scan(CarIndex index, std::size_t lidar, float * ranges) const
{
  impl_->scan(index, lidar, true, ranges);
}

void Simulation::exactScan(CarIndex index, std::size_t lidar, float * ranges) const
{
  impl_->scan(index, lidar, false, ranges);
}

const std::vector<Contact> & Simulation::contacts(CarIndex index) const
{
  return impl_->car(index).contactLog().contacts();
}

void Simulation::clearContacts(CarIndex index)
{
  impl_->car(index).contactLog().clear();
}

double Simulation::clearance(CarIndex index, double limit) const
{
  impl_->car(index);
  return f1tenth_sim2d::clearance(placedCars(impl_->cars()), index, impl_->collisions(), limit);
}

const std::vector<ModelDescription> & Simulation::models() const
{
  return impl_->world().models;
}

ModelState Simulation::modelState(std::size_t index) const
{
  return impl_->collisions().modelState(index);
}

void Simulation::addModel(const ModelDescription & model)
{
  impl_->addModel(model);
}

void Simulation::removeModel(std::size_t index)
{
  impl_->removeModel(index);
}

void Simulation::placeModel(std::size_t index, const ModelState & state)
{
  impl_->placeModel(index, state);
}

Pose2 Simulation::modelPose(const std::string & model) const
{
  const std::vector<ModelDescription> & models = impl_->world().models;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].name == model) {
      return impl_->collisions().modelState(i).pose;
    }
  }
  throw Error("there is no model " + model + " in " + impl_->world().file);
}

std::vector<std::string> Simulation::modelNames() const
{
  std::vector<std::string> names;
  for (const ModelDescription & model : impl_->world().models) {
    names.push_back(model.name);
  }
  return names;
}

void Simulation::appendStateBytes(std::vector<std::uint8_t> & bytes) const
{
  for (const auto & car : impl_->cars()) {
    appendBytes(car->dynamicState(), bytes);
  }
}
}  // namespace f1tenth_sim2d
