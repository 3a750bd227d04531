#include "sim2d_node.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "car_outputs.h"
#include "continuous_time.h"
#include "diagnostics_output.h"
#include "lockstep_time.h"
#include "plugin_output.h"
#include "stop_signal.h"

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
}  // namespace

Sim2dNode::Sim2dNode(const NodeParameters & parameters)
: parameters_(parameters),
  node_(nodeWithQueue("/", queue_)),
  outbox_(node_, parameters.time_mode == TimeMode::kLockstep),
  flow_(outbox_, queue_, {parameters.time_mode != TimeMode::kPaced, parameters.silent_subscriber_timeout_sec}),
  transforms_(outbox_, node_),
  scene_(buildScene(parameters)),
  plugins_(pluginFoldersFromEnvironment()),
  world_(scene_.simulation, transforms_, parameters.control_period_sec, parameters.record_file),
  clock_(outbox_, node_)
{
  control_.paused = parameters_.paused;
  if (parameters_.time_mode == TimeMode::kLockstep) {
    barrier_ = std::make_unique<LockstepBarrier>(
      node_, queue_,
      LockstepOptions{
        parameters_.participants, parameters_.lockstep_timeout_sec, parameters_.lockstep_startup_timeout_sec});
  }
  for (CarIndex car = 0; car < scene_.simulation.carCount(); ++car) {
    addCarOutputs(car);
    addPlugins(car);
    addCommands(car);
  }
  addGlobalOutputs();
  makeTimeKeeper();
  services_ = std::make_unique<GazeboServices>(node_, scene_.simulation, control_, [this] { restart(); });
}

ros::NodeHandle Sim2dNode::carNode(CarIndex car)
{
  return nodeWithQueue("/" + parameters_.cars[car].name, queue_);
}

void Sim2dNode::addCarOutputs(CarIndex car)
{
  const CarHandle handle{scene_.simulation, car, outbox_, carNode(car), parameters_.cars[car].frame_prefix};
  const CarDescription & description = handle.description();
  for (std::size_t lidar = 0; lidar < description.lidars.size(); ++lidar) {
    world_.addScan(car, std::make_unique<ScanOutput>(handle, lidar));
  }
  for (std::size_t bumper = 0; bumper < description.bumpers.size(); ++bumper) {
    world_.addBumper(car, std::make_unique<BumperOutput>(handle, bumper));
  }
  world_.add(std::make_unique<OdometryOutput>(handle));
  if (parameters_.odometry == OdometryOwner::kWheel) {
    world_.add(std::make_unique<OdometryTransformOutput>(handle, transforms_));
  }
  if (description.imu) {
    world_.add(std::make_unique<ImuOutput>(handle, scene_.gravity));
  }
  world_.add(std::make_unique<JointStatesOutput>(handle));
}

void Sim2dNode::addPlugins(CarIndex car)
{
  const CarPluginContext context{
    scene_.simulation,
    car,
    carNode(car),
    outbox_,
    transforms_,
    parameters_.cars[car].frame_prefix,
    parameters_.odometry == OdometryOwner::kPerfect};
  for (const auto & element : scene_.simulation.car(car).plugins) {
    if (auto plugin = plugins_.make(element, context)) {
      world_.add(std::make_unique<PluginOutput>(std::move(plugin)));
    }
  }
}

void Sim2dNode::addCommands(CarIndex car)
{
  const std::string & name = parameters_.cars[car].name;
  const auto & participants = parameters_.participants;
  std::function<void()> on_command = [] {};
  if (barrier_ && std::find(participants.begin(), participants.end(), name) != participants.end()) {
    checkScanEveryPeriod(scene_.simulation.car(car), parameters_.control_period_sec);
    on_command = [this, name] { barrier_->noteCommand(name); };
  }
  commands_.push_back(std::make_unique<CommandInput>(scene_.simulation, car, carNode(car), std::move(on_command)));
}

void Sim2dNode::addGlobalOutputs()
{
  world_.add(std::make_unique<ModelStatesOutput>(outbox_, node_, scene_.simulation));
  std::vector<DiagnosticsOutput::Driver> drivers;
  for (CarIndex car = 0; car < commands_.size(); ++car) {
    drivers.push_back({parameters_.cars[car].name, *commands_[car]});
  }
  world_.add(std::make_unique<DiagnosticsOutput>(
    outbox_.advertise<diagnostic_msgs::DiagnosticArray>(node_, "/diagnostics"), parameters_.time_mode,
    parameters_.real_time_factor, std::move(drivers), flow_));
}

void Sim2dNode::makeTimeKeeper()
{
  if (parameters_.time_mode == TimeMode::kLockstep) {
    time_ =
      std::make_unique<LockstepTime>(scene_.simulation, world_, queue_, control_, outbox_, flow_, clock_, *barrier_);
    return;
  }
  // Last of all that is due at the same time, as in lockstep.
  world_.schedule().add(periodOf(parameters_.clock_rate_hz), [this](SimTime now) { clock_.publish(now); });
  if (parameters_.time_mode == TimeMode::kPaced) {
    time_ = std::make_unique<PacedTime>(world_, queue_, control_, outbox_, flow_, parameters_.real_time_factor);
  } else {
    time_ = std::make_unique<FreeTime>(world_, queue_, control_, outbox_, flow_);
  }
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
  time_->restart();
  int restarts = control_.restarts;
  while (!stopRequested()) {
    if (control_.paused) {
      queue_.callAvailable(kPauseCheck);
    } else {
      time_->advance();
    }
    if (control_.paused || control_.restarts != restarts) {
      restarts = control_.restarts;
      time_->restart();
    }
  }
  outbox_.flush();
  flow_.drain();
}

RunResult Sim2dNode::result() const
{
  RunResult result;
  result.sim_time_sec = static_cast<double>(world_.time()) * 1e-9;
  result.wall_time_sec = (ros::WallTime::now() - wall_start_).toSec();
  result.periods = world_.periods();
  result.trajectory_hash = world_.hash();
  result.seed = parameters_.simulation.seed;
  for (const auto & topic : outbox_.topics()) {
    result.published[topic->name()] = topic->published();
  }
  result.lost = flow_.lostMessages();
  return result;
}
}  // namespace f1tenth_sim2d
