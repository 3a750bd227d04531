#include "node/cars/fleet.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "f1tenth_sim2d/errors.h"
#include "node/cars/plugin_output.h"
#include "node/cars/ros_control.h"

namespace f1tenth_sim2d
{
namespace
{
// Without a scan in every period, its driver would have nothing to answer.
void checkScanEveryPeriod(const CarDescription & car, double control_period_sec)
{
  const bool has_scan = std::any_of(car.lidars.begin(), car.lidars.end(), [&](const LidarDescription & lidar) {
    return lidar.rate_hz * control_period_sec > 1.0 - 1e-9;
  });
  if (!has_scan) {
    std::ostringstream message;
    message << "parameter participants: " << car.name << " has no lidar that scans in every control_period of "
            << control_period_sec << " s";
    throw Error(message.str());
  }
}

/// Does something at the end of a scope that is left by an exception.
template <typename Action>
class OnFailure
{
public:
  explicit OnFailure(Action action) : action_(std::move(action)) {}
  OnFailure(const OnFailure &) = delete;
  OnFailure & operator=(const OnFailure &) = delete;
  ~OnFailure()
  {
    if (armed_) {
      action_();
    }
  }
  void dismiss() { armed_ = false; }

private:
  Action action_;
  bool armed_{true};
};

bool contains(const std::vector<std::string> & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}
}  // namespace

Fleet::Fleet(const Surroundings & surroundings) : around_(surroundings) {}

ros::NodeHandle Fleet::nodeOf(const Car & car) const
{
  return {around_.node, car.parameters.ros_namespace};
}

void Fleet::add(
  const CarParameters & parameters, const CarDescription & description, const VehicleParameters & vehicle,
  const Pose2 & pose)
{
  if (around_.barrier != nullptr && contains(around_.parameters.participants, parameters.name)) {
    checkScanEveryPeriod(description, around_.parameters.control_period_sec);
  }
  cars_.reserve(cars_.size() + 1);
  auto car = std::make_unique<Car>();
  car->parameters = parameters;
  car->id = around_.simulation.addCar(description, vehicle, pose);
  OnFailure undo([&] { removeFromWorld(car->id); });
  addCommands(*car);
  around_.world.addCar(car->id, makeOutputs(*car));
  cars_.push_back(std::move(car));
  undo.dismiss();
}

void Fleet::remove(CarId id)
{
  removeFromWorld(id);
  const auto found = std::find_if(cars_.begin(), cars_.end(), [&](const auto & car) { return car->id == id; });
  cars_.erase(found);
}

// Its outputs refer to the car.
void Fleet::removeFromWorld(CarId id)
{
  around_.world.removeCar(id);
  around_.simulation.removeCar(id);
}

CarOutputs Fleet::makeOutputs(const Car & car)
{
  const CarHandle handle{around_.simulation, car.id, around_.outbox, nodeOf(car), car.parameters.frame_prefix};
  const CarDescription & description = handle.description();
  CarOutputs outputs;
  for (std::size_t lidar = 0; lidar < description.lidars.size(); ++lidar) {
    outputs.scans.push_back(std::make_unique<ScanOutput>(handle, lidar));
  }
  for (std::size_t bumper = 0; bumper < description.bumpers.size(); ++bumper) {
    outputs.bumpers.push_back(std::make_unique<BumperOutput>(handle, bumper));
  }
  addOdometry(handle, outputs);
  if (description.imu) {
    outputs.others.push_back(std::make_unique<ImuOutput>(handle, around_.gravity));
  }
  if (!description.joints.empty()) {
    outputs.others.push_back(std::make_unique<JointStatesOutput>(
      handle, description.joint_state_topic, description.joint_state_rate_hz, description.joints));
  }
  if (description.ros_control) {
    CarHandle control = handle;
    control.node = ros::NodeHandle(handle.node, description.ros_control->ros_namespace);
    outputs.others.push_back(std::make_unique<RosControl>(control, *car.commands));
  }
  addPlugins(car, outputs);
  return outputs;
}

void Fleet::addOdometry(const CarHandle & car, CarOutputs & outputs) const
{
  const OdometryPlace place = odometryPlace(car.description(), around_.simulation.parameters(car.id));
  if (place.has_topic) {
    outputs.others.push_back(std::make_unique<OdometryOutput>(car, place));
  }
  // A drive plugin owns the transform of a car that has no other odometry.
  const bool owns_transform = around_.parameters.odometry == OdometryOwner::kWheel || car.description().drive;
  if (place.has_transform && owns_transform) {
    outputs.others.push_back(std::make_unique<OdometryTransformOutput>(car, place, around_.transforms));
  }
  for (const auto & sensor : car.description().pose_sensors) {
    outputs.others.push_back(std::make_unique<PoseOutput>(car, sensor));
  }
}

void Fleet::addPlugins(const Car & car, CarOutputs & outputs)
{
  const CarPluginContext context{
    around_.simulation,
    car.id,
    nodeOf(car),
    around_.outbox,
    around_.transforms,
    car.parameters.frame_prefix,
    around_.parameters.odometry == OdometryOwner::kPerfect};
  for (const auto & element : around_.simulation.car(car.id).plugins) {
    if (auto plugin = around_.plugins.make(element, context)) {
      outputs.others.push_back(std::make_unique<PluginOutput>(std::move(plugin)));
    }
  }
}

void Fleet::addCommands(Car & car)
{
  const std::string name = car.parameters.name;
  std::function<void()> on_command = [] {};
  if (around_.barrier != nullptr && contains(around_.parameters.participants, name)) {
    on_command = [barrier = around_.barrier, name] { barrier->noteCommand(name); };
  }
  car.commands = std::make_unique<CommandInput>(around_.simulation, car.id, nodeOf(car), std::move(on_command));
}

std::vector<DiagnosticsOutput::Driver> Fleet::drivers() const
{
  std::vector<DiagnosticsOutput::Driver> drivers;
  for (const auto & car : cars_) {
    drivers.push_back({car->parameters.name, *car->commands});
  }
  return drivers;
}
}  // namespace f1tenth_sim2d
