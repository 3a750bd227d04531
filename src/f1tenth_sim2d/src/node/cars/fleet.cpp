#include "node/cars/fleet.h"

#include <memory>
#include <utility>

#include "node/cars/component_outputs.h"
#include "node/cars/controllers/ros_control.h"

namespace f1tenth_sim2d
{
namespace
{
/// What the controllers of ros_control publish.
class ControllersOutput : public Output
{
public:
  explicit ControllersOutput(std::shared_ptr<RosControl> control) : control_(std::move(control)) {}
  double rate() const override { return control_->rate(); }
  void update(SimTime now, bool /*anyway*/) override { control_->publish(now); }
  void repeat() override {}

private:
  const std::shared_ptr<RosControl> control_;
};

/// What a plugin publishes.
class PluginOutput : public Output
{
public:
  explicit PluginOutput(std::shared_ptr<CarPlugin> plugin) : plugin_(std::move(plugin)) {}
  double rate() const override { return plugin_->updateRate(); }

  void update(SimTime now, bool /*anyway*/) override
  {
    stamp_ = toRosTime(now);
    plugin_->update(stamp_);
  }

  void repeat() override
  {
    if (!stamp_.isZero()) {
      plugin_->update(stamp_);
    }
  }

private:
  const std::shared_ptr<CarPlugin> plugin_;
  ros::Time stamp_;
};
}  // namespace

Fleet::Fleet(Surroundings surroundings) : around_(std::move(surroundings)) {}

Fleet::Car::Car(
  Fleet & fleet, const CarParameters & car, const CarDescription & description, const VehicleParameters & vehicle,
  const Pose2 & pose)
: parameters(car),
  simulated(fleet.around_.simulation, description, vehicle, pose),
  commands(
    fleet.around_.simulation, simulated.id(), {fleet.around_.node, car.ros_namespace},
    fleet.around_.driver_of(car.name)),
  outputs(fleet.around_.world, fleet.makeOutputs(*this), simulated.id())
{
}

void Fleet::add(
  const CarParameters & parameters, const CarDescription & description, const VehicleParameters & vehicle,
  const Pose2 & pose)
{
  auto car = std::make_unique<Car>(*this, parameters, description, vehicle, pose);
  const CarId id = car->simulated.id();
  cars_.emplace(id, std::move(car));
}

CarHandle Fleet::handleOf(const Car & car) const
{
  return {
    around_.simulation,
    car.simulated.id(),
    around_.advertiser,
    around_.transforms,
    {around_.node, car.parameters.ros_namespace},
    car.parameters.frame_prefix};
}

OutputList Fleet::makeOutputs(Car & car) const
{
  const CarHandle handle = handleOf(car);
  const CarDescription & description = handle.description();
  OutputList outputs;
  for (const auto & component : around_.simulation.components(handle.id)) {
    if (auto output = makeOutput(handle, *component)) {
      outputs.push_back(std::move(output));
    }
  }
  for (const BumperDescription & bumper : description.bumpers) {
    outputs.push_back(std::make_unique<BumperOutput>(handle, bumper));
  }
  addOdometry(handle, outputs);
  if (!description.joints.empty()) {
    outputs.push_back(std::make_unique<JointStatesOutput>(
      handle, description.joint_state_topic, description.joint_state_rate_hz, description.joints));
  }
  if (description.ros_control) {
    CarHandle control = handle;
    control.node = ros::NodeHandle(handle.node, description.ros_control->ros_namespace);
    const auto controllers = std::make_shared<RosControl>(control, car.commands);
    around_.simulation.mount(handle.id, controllers);
    outputs.push_back(std::make_unique<ControllersOutput>(controllers));
  }
  addPlugins(handle, outputs);
  return outputs;
}

void Fleet::addOdometry(const CarHandle & car, OutputList & outputs) const
{
  const OdometryPlace place = odometryPlace(car.description(), around_.simulation.parameters(car.id));
  if (place.has_topic) {
    outputs.push_back(std::make_unique<OdometryOutput>(car, place));
  }
  // A drive plugin owns the transform of a car that has no other odometry.
  const bool owns_transform = around_.odometry == OdometryOwner::kWheel || car.description().drive;
  if (place.has_transform && owns_transform) {
    outputs.push_back(std::make_unique<OdometryTransformOutput>(car, place));
  }
  for (const auto & sensor : car.description().pose_sensors) {
    outputs.push_back(std::make_unique<PoseOutput>(car, sensor));
  }
}

void Fleet::addPlugins(const CarHandle & car, OutputList & outputs) const
{
  const CarPluginContext context{
    car.simulation,
    car.id,
    car.node,
    car.advertiser,
    car.transforms,
    car.frame_prefix,
    around_.odometry == OdometryOwner::kPerfect};
  for (const auto & element : car.description().plugins) {
    if (auto plugin = around_.plugins.make(element, context)) {
      around_.simulation.mount(car.id, plugin);
      outputs.push_back(std::make_unique<PluginOutput>(std::move(plugin)));
    }
  }
}

std::vector<Fleet::Driver> Fleet::drivers() const
{
  std::vector<Driver> drivers;
  for (const auto & [id, car] : cars_) {
    drivers.push_back({car->parameters.name, car->commands});
  }
  return drivers;
}
}  // namespace f1tenth_sim2d
