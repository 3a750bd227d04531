#include "node/parameters/node_parameters.h"

#include <workspace_support/errors.h>
#include <workspace_support/parameter_reader.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "node/messages/conversions.h"
#include "node/parameters/limits.h"

namespace f1tenth_sim2d
{
namespace
{
using workspace_support::atLeast;
using workspace_support::OptionError;
using workspace_support::ParameterReader;
using workspace_support::positive;

bool isCarName(const std::string & name)
{
  const auto isWordCharacter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::all_of(name.begin(), name.end(), isWordCharacter);
}

void readPose(ParameterReader & reader, std::optional<Pose2> & value)
{
  Pose2 pose;
  const bool has_x = reader.read("x", pose.x);
  const bool has_y = reader.read("y", pose.y);
  const bool has_yaw = reader.read("yaw", pose.yaw);
  if (has_x || has_y || has_yaw) {
    value = pose;
  }
}

CarParameters readCar(ParameterReader reader, const std::string & name)
{
  CarParameters car;
  car.name = name;
  car.ros_namespace = "/" + name;
  car.frame_prefix = name + "/";
  readPose(reader, car.pose);
  reader.read("relative_to_start", car.relative_to_start);
  reader.read("vehicle", car.vehicle_file);
  reader.read("frame_prefix", car.frame_prefix);
  reader.refuseUnused();
  return car;
}

void readCars(ParameterReader reader, std::vector<CarParameters> & cars)
{
  for (const std::string & name : reader.keys()) {
    if (!isCarName(name)) {
      throw OptionError(
        "parameter " + reader.fullName(name) + ": found the car name \"" + name +
        "\", must be letters, digits and _, a letter first");
    }
    const CarParameters car = readCar(reader.below(name), name);
    const auto has_same_prefix = [&](const CarParameters & other) { return other.frame_prefix == car.frame_prefix; };
    if (std::any_of(cars.begin(), cars.end(), has_same_prefix)) {
      throw OptionError(
        "parameter " + reader.fullName(name + "/frame_prefix") + ": found \"" + car.frame_prefix +
        "\" twice, must be a different one for each car");
    }
    cars.push_back(car);
  }
}

void readTime(ParameterReader & reader, NodeParameters & parameters)
{
  reader.read("real_time_factor", parameters.real_time_factor, realTimeFactor());
  reader.read("lockstep", parameters.is_lockstep);
  reader.read("participants", parameters.lockstep.participants);
  reader.read("lockstep_timeout", parameters.lockstep.timeout_sec, patience());
  reader.read("lockstep_startup_timeout", parameters.lockstep.startup_timeout_sec, patience());
  reader.read("paused", parameters.paused);
  reader.read("clock_rate", parameters.clock_rate_hz, frequency());
}

void readSteps(ParameterReader & reader, NodeParameters & parameters)
{
  reader.read("physics_step", parameters.simulation.physics_step, positive());
  const double physics_step = parameters.simulation.physics_step;
  const auto isMultiple = [&](double period) {
    const double steps = period / physics_step;
    return period > 0.0 && period <= kLongestPeriod && std::round(steps) >= 1.0 &&
           std::abs(steps - std::round(steps)) < 1e-6;
  };
  reader.read(
    "control_period", parameters.control_period_sec,
    {isMultiple, " of seconds that is a multiple of physics_step and <= 1000"});
}
}  // namespace

Pose2 startPose(const CarParameters & car, const Pose2 & world_start)
{
  if (!car.pose || !car.relative_to_start) {
    return car.pose.value_or(world_start);
  }
  const Vec2 offset = rotated({car.pose->x, car.pose->y}, world_start.yaw);
  return {world_start.x + offset.x, world_start.y + offset.y, world_start.yaw + car.pose->yaw};
}

NodeParameters parseNodeParameters(const std::string & name, const XmlRpc::XmlRpcValue & all)
{
  ParameterReader reader(name, all);
  NodeParameters parameters;
  reader.readRequired("world", parameters.world_file);
  readCars(reader.below("cars"), parameters.cars);
  readTime(reader, parameters);
  readSteps(reader, parameters);
  int seed = 0;
  reader.read("seed", seed, atLeast(0));
  parameters.simulation.seed = static_cast<std::uint64_t>(seed);
  reader.readChoice(
    "odometry", parameters.odometry, {{"perfect", OdometryOwner::kPerfect}, {"wheel", OdometryOwner::kWheel}});
  reader.read("record", parameters.record_file);
  reader.read("interventions", parameters.interventions_file);
  reader.ignore({"result_file"});  // parseResultFile() has read it
  reader.refuseUnused();
  return parameters;
}

std::string parseResultFile(const std::string & name, const XmlRpc::XmlRpcValue & all)
{
  std::string file;
  ParameterReader(name, all).read("result_file", file);
  return file;
}
}  // namespace f1tenth_sim2d
