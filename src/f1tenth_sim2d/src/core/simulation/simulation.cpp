#include "f1tenth_sim2d/simulation.h"

#include "core/contacts/clearance.h"
#include "core/simulation/simulation_impl.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
Simulation::Simulation(const PreparedWorld & world, const SimulationOptions & options)
: impl_(std::make_unique<Impl>(world.geometry_, options))
{
}
Simulation::Simulation(const WorldDescription & world, const SimulationOptions & options)
: Simulation(PreparedWorld(world), options)
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation &&) noexcept = default;
Simulation & Simulation::operator=(Simulation &&) noexcept = default;

CarId Simulation::addCar(const CarDescription & car, const VehicleParameters & parameters, const Pose2 & pose)
{
  return impl_->addCar(car, parameters, pose);
}

void Simulation::removeCar(CarId car)
{
  impl_->removeCar(car);
}

void Simulation::placeCar(CarId car, const Pose2 & pose, const Vec2 & velocity, double yaw_rate)
{
  impl_->placeCar(car, pose, velocity, yaw_rate);
}

const std::vector<CarId> & Simulation::cars() const
{
  return impl_->registry().ids();
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

void Simulation::command(CarId car, const DriveCommand & command)
{
  RegisteredCar & driven = impl_->car(car);
  validate(command, driven.description.name);
  driven.car.command(command, impl_->time());
}

void Simulation::commandTwist(CarId car, double linear_x, double angular_z, double linear_y)
{
  RegisteredCar & driven = impl_->car(car);
  validateTwist({linear_x, linear_y}, angular_z, driven.description.name);
  driven.car.command(TwistCommand{{linear_x, linear_y}, angular_z}, impl_->time());
}

CarState Simulation::state(CarId car) const
{
  return impl_->car(car).car.state();
}
WheelOdometry Simulation::wheelOdometry(CarId car) const
{
  return impl_->car(car).car.wheelOdometry();
}
ImuSample Simulation::imu(CarId car) const
{
  return impl_->imu(car);
}

void Simulation::scan(CarId car, std::size_t lidar, float * ranges) const
{
  impl_->scan(car, lidar, true, ranges);
}

void Simulation::exactScan(CarId car, std::size_t lidar, float * ranges) const
{
  impl_->scan(car, lidar, false, ranges);
}

void Simulation::castRays(CarId car, const RayFan & fan, double * ranges) const
{
  impl_->castRays(car, fan, ranges);
}

double Simulation::noise(CarId car, const std::string & sensor, std::uint64_t index) const
{
  return impl_->noise(car, sensor, index);
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
  const CarRegistry & registry = impl_->registry();
  return f1tenth_sim2d::clearance(placedCars(registry.cars()), registry.indexOf(car), impl_->collisions(), limit);
}

const WorldDescription & Simulation::world() const
{
  return impl_->world();
}

const std::vector<ModelDescription> & Simulation::models() const
{
  return world().models;
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

std::size_t Simulation::indexOfModel(const std::string & model) const
{
  const std::vector<ModelDescription> & models = impl_->world().models;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].name == model) {
      return i;
    }
  }
  throw Error("there is no model " + model + " in " + impl_->world().file);
}

Pose2 Simulation::modelPose(const std::string & model) const
{
  return modelState(indexOfModel(model)).pose;
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
  for (const auto & car : impl_->registry().cars()) {
    const BodyState & s = car->car.dynamicState();
    const double values[]{s.x, s.y, s.delta, s.v, s.psi, s.psi_dot, s.beta};
    // In the order of bytes of the machine, which is a little-endian one.
    const auto * const first = reinterpret_cast<const std::uint8_t *>(values);
    bytes.insert(bytes.end(), first, first + sizeof(values));
  }
}
}  // namespace f1tenth_sim2d
