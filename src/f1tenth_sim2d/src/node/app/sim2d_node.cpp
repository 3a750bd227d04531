#include "node/app/sim2d_node.h"

#include <ros/console.h>
#include <ros/param.h>
#include <rosgraph_msgs/Clock.h>
#include <sim2d_lockstep/participant.h>

#include <utility>

#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "loaders/files/files.h"
#include "node/app/diagnostics_output.h"
#include "node/gazebo_api/gazebo_states.h"
#include "node/time/continuous_time.h"
#include "node/time/lockstep_time.h"
#include "node/time/stop_signal.h"
#include "node/world/warnings.h"

namespace f1tenth_sim2d
{
namespace
{
const ros::WallDuration kPauseCheck{0.1};

ros::NodeHandle nodeWithQueue(const std::string & name_space, ros::CallbackQueue & queue)
{
  ros::NodeHandle node(name_space);
  node.setCallbackQueue(&queue);
  return node;
}

TimeControl controlOf(const NodeParameters & parameters)
{
  TimeControl control;
  control.paused = parameters.paused;
  control.is_lockstep = parameters.is_lockstep;
  control.real_time_factor = parameters.is_lockstep ? 0.0 : parameters.real_time_factor;
  return control;
}

/// Without cars; warns once of what cannot be represented of the world.
Simulation simulationOf(const NodeParameters & parameters)
{
  const WorldDescription world = loadWorld(parameters.world_file, searchPathFromEnvironment());
  warnOnce(world.file, world.warnings);
  return Simulation(world, parameters.simulation);
}

std::string descriptionParameter(const CarParameters & car)
{
  return "/" + car.name + "/robot_description";
}

/// The URDF or SDF text of a car.
std::string readDescription(const CarParameters & car)
{
  const std::string parameter = descriptionParameter(car);
  std::string xml;
  if (!ros::param::get(parameter, xml)) {
    throw Error("parameter " + parameter + ": not set, expected the URDF or SDF text of the car");
  }
  return xml;
}

/// Puts the cars of the parameters into the fleet; reads their descriptions (/NAME/robot_description) and vehicle
/// files.
/// @param start  where the world says that cars without a pose of their own start
/// @return what each car was made of, as a hash
std::map<std::string, std::string> addCars(const std::vector<CarParameters> & cars, const Pose2 & start, Fleet & fleet)
{
  std::map<std::string, std::string> hashes;
  for (const auto & car : cars) {
    const std::string xml = readDescription(car);
    const CarDescription description = loadCar(xml, car.name, descriptionParameter(car), searchPathFromEnvironment());
    hashes[car.name] = sha256(xml + (car.vehicle_file.empty() ? "" : readFile(car.vehicle_file)));
    warnOnce(description.source, description.warnings);
    const VehicleParameters vehicle =
      car.vehicle_file.empty() ? description.parameters : loadVehicleParameters(car.vehicle_file);
    fleet.add(car, description, vehicle, startPose(car, start));
  }
  return hashes;
}
}  // namespace

Sim2dNode::Sim2dNode(const NodeParameters & parameters)
: parameters_(parameters),
  node_(nodeWithQueue("/", queue_)),
  transforms_(advertiser_, node_),
  simulation_(simulationOf(parameters)),
  plugins_(pluginFoldersFromEnvironment()),
  world_(simulation_, transforms_, parameters.control_period_sec, parameters.record_file),
  world_sha256_(sha256(readFile(simulation_.world().file))),
  interventions_(parameters.interventions_file),
  control_(controlOf(parameters)),
  clock_(advertiser_.advertise<rosgraph_msgs::Clock>(node_, "/clock")),
  barrier_(makeBarrier()),
  fleet_(surroundings()),
  models_(node_, simulation_, fleet_, interventions_),
  world_services_(
    node_, simulation_, control_, {[this] { restart(); }, [this] { world_.resetPoses(); }}, interventions_)
{
  cars_sha256_ = addCars(parameters_.cars, simulation_.world().start, fleet_);
  global_outputs_.emplace(world_, globalOutputs());
  addClock();
  if (parameters_.cars.empty()) {
    ROS_INFO(
      "No car yet: the parameter cars is empty (rosparam drops an empty map: cars: {robot1: {x: 0.0}}). Cars may be "
      "spawned");
  }
}

std::unique_ptr<LockstepBarrier> Sim2dNode::makeBarrier()
{
  if (!parameters_.is_lockstep) {
    return nullptr;
  }
  const auto note = [this](const std::string & node, const std::string & participant) {
    interventions_.add(simulation_.time(), {"sim2d/done", node, participant});
  };
  return std::make_unique<LockstepBarrier>(node_, queue_, parameters_.lockstep, note);
}

Fleet::Surroundings Sim2dNode::surroundings()
{
  const auto driver_of = [this](const std::string & car) {
    return barrier_ ? barrier_->driverOf(car) : CommandInput::Answered([](const ros::Time &) {});
  };
  return {parameters_.odometry, node_, simulation_, world_, advertiser_, transforms_, plugins_, driver_of};
}

OutputList Sim2dNode::globalOutputs()
{
  OutputList outputs;
  outputs.push_back(std::make_unique<EntityStatesOutput<gazebo_msgs::ModelStates>>(
    advertiser_.advertise<gazebo_msgs::ModelStates>(node_, "/gazebo/model_states"), simulation_, &entities));
  outputs.push_back(std::make_unique<EntityStatesOutput<gazebo_msgs::LinkStates>>(
    advertiser_.advertise<gazebo_msgs::LinkStates>(node_, "/gazebo/link_states"), simulation_, &links));
  outputs.push_back(std::make_unique<DiagnosticsOutput>(
    advertiser_.advertise<diagnostic_msgs::DiagnosticArray>(node_, "/diagnostics"), control_,
    [this] { return fleet_.drivers(); }));
  return outputs;
}

void Sim2dNode::addClock()
{
  if (!control_.is_lockstep) {
    world_.schedule().add(periodOf(parameters_.clock_rate_hz), [this](SimTime now) { clock_.publish(toClock(now)); });
  }
}

std::unique_ptr<TimeKeeper> Sim2dNode::makeTimeKeeper()
{
  if (control_.is_lockstep) {
    return std::make_unique<LockstepTime>(simulation_, world_, queue_, control_, advertiser_, clock_, *barrier_);
  }
  if (control_.real_time_factor > 0.0) {
    return std::make_unique<PacedTime>(world_, queue_, control_);
  }
  return std::make_unique<FreeTime>(world_, queue_, control_);
}

void Sim2dNode::restart()
{
  world_.restart();
  ++control_.restarts;
  if (barrier_) {
    barrier_->restart();
  }
}

void Sim2dNode::run()
{
  wall_start_ = ros::WallTime::now();
  auto time = makeTimeKeeper();
  TimeControl seen = control_;
  while (!stopRequested()) {
    if (control_.paused) {
      queue_.callAvailable(kPauseCheck);
    } else {
      time->advance();
    }
    if (control_.real_time_factor != seen.real_time_factor) {
      time = makeTimeKeeper();
    } else if (control_.paused || control_.restarts != seen.restarts) {
      time->restart();
    }
    seen = control_;
  }
  // First of all: on a busy machine whoever asked for the end may lose patience while ROS shuts down.
  world_.finishPeriod();
  drain_.drain();
}

RunResult Sim2dNode::result() const
{
  RunResult result;
  result.sim_time_sec = static_cast<double>(world_.time()) * 1e-9;
  result.wall_time_sec = (ros::WallTime::now() - wall_start_).toSec();
  result.periods = world_.periods();
  result.trajectory_hash = world_.hash();
  result.seed = parameters_.simulation.seed;
  if (barrier_) {
    result.strays = barrier_->strays();
  }
  result.physics_step_sec = parameters_.simulation.physics_step;
  result.world_sha256 = world_sha256_;
  result.cars_sha256 = cars_sha256_;
  return result;
}
}  // namespace f1tenth_sim2d
