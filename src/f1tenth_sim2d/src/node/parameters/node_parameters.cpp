#include "node/parameters/node_parameters.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "f1tenth_sim2d/errors.h"
#include "node/messages/conversions.h"
#include "node/parameters/parameter_reader.h"

namespace f1tenth_sim2d
{
namespace
{
const std::vector<std::string> kNodeKeys{
  "world",
  "cars",
  "real_time_factor",
  "lockstep",
  "participants",
  "lockstep_timeout",
  "lockstep_startup_timeout",
  "control_period",
  "physics_step",
  "seed",
  "clock_rate",
  "paused",
  "silent_subscriber_timeout",
  "odometry",
  "record",
  "result_file"};
const std::vector<std::string> kCarKeys{"x", "y", "yaw", "relative_to_start", "vehicle", "frame_prefix"};

const NumberRule kAny{[](double) { return true; }, "a finite number"};
const NumberRule kPositive{[](double value) { return value > 0.0; }, "a number > 0"};
const NumberRule kNotNegative{[](double value) { return value >= 0.0; }, "a number >= 0 (0: as fast as it goes)"};

bool isCarName(const std::string & name)
{
  const auto isWordCharacter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::all_of(name.begin(), name.end(), isWordCharacter);
}

std::optional<Pose2> parsePose(ParameterReader & reader, const XmlRpc::XmlRpcValue & car)
{
  const Pose2 pose{reader.number("x", 0.0, kAny), reader.number("y", 0.0, kAny), reader.number("yaw", 0.0, kAny)};
  const bool told = car.hasMember("x") || car.hasMember("y") || car.hasMember("yaw");
  return told ? std::optional<Pose2>(pose) : std::nullopt;
}

CarParameters parseCar(const std::string & cars_name, const std::string & name, const XmlRpc::XmlRpcValue & value)
{
  if (name.empty() || !isCarName(name)) {
    throw Error(
      "parameter " + cars_name + ": found the car name \"" + name +
      "\", expected letters, digits and _, a letter first");
  }
  ParameterReader reader(cars_name + "/" + name, value, kCarKeys);
  CarParameters car;
  car.name = name;
  car.ros_namespace = "/" + name;
  car.pose = parsePose(reader, value);
  car.relative_to_start = reader.flag("relative_to_start", car.relative_to_start);
  car.vehicle_file = reader.text("vehicle", "");
  car.frame_prefix = reader.text("frame_prefix", name + "/");
  return car;
}

std::vector<CarParameters> parseCars(ParameterReader & reader)
{
  std::vector<CarParameters> cars;
  for (auto & [name, value] : reader.optionalMap("cars")) {
    cars.push_back(parseCar(reader.fullName("cars"), name, value));
    const auto same_prefix = [&](const CarParameters & car) { return car.frame_prefix == cars.back().frame_prefix; };
    if (std::count_if(cars.begin(), cars.end(), same_prefix) > 1) {
      throw Error(
        "parameter " + reader.fullName("cars/" + name + "/frame_prefix") + ": found \"" + cars.back().frame_prefix +
        "\" twice, expected a different one for each car");
    }
  }
  return cars;
}

TimeMode parseTimeMode(ParameterReader & reader, double real_time_factor)
{
  if (reader.flag("lockstep", false)) {
    return TimeMode::kLockstep;
  }
  return real_time_factor > 0.0 ? TimeMode::kPaced : TimeMode::kFree;
}

double parseControlPeriod(ParameterReader & reader, double physics_step)
{
  const auto isMultiple = [&](double period) {
    const double steps = period / physics_step;
    return period > 0.0 && std::round(steps) >= 1.0 && std::abs(steps - std::round(steps)) < 1e-6;
  };
  return reader.number("control_period", 0.025, {isMultiple, "a multiple of physics_step (s)"});
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
  ParameterReader reader(name, all, kNodeKeys);
  NodeParameters parameters;
  parameters.world_file = reader.requiredText("world");
  parameters.cars = parseCars(reader);
  parameters.real_time_factor = reader.number("real_time_factor", parameters.real_time_factor, kNotNegative);
  parameters.time_mode = parseTimeMode(reader, parameters.real_time_factor);
  parameters.participants = reader.names("participants");
  parameters.lockstep_timeout_sec = reader.number("lockstep_timeout", parameters.lockstep_timeout_sec, kPositive);
  parameters.lockstep_startup_timeout_sec =
    reader.number("lockstep_startup_timeout", parameters.lockstep_startup_timeout_sec, kPositive);
  parameters.simulation.physics_step = reader.number("physics_step", parameters.simulation.physics_step, kPositive);
  parameters.control_period_sec = parseControlPeriod(reader, parameters.simulation.physics_step);
  parameters.simulation.seed = static_cast<std::uint64_t>(reader.natural("seed", 0));
  parameters.clock_rate_hz = reader.number("clock_rate", parameters.clock_rate_hz, kPositive);
  parameters.paused = reader.flag("paused", false);
  parameters.silent_subscriber_timeout_sec =
    reader.number("silent_subscriber_timeout", parameters.silent_subscriber_timeout_sec, kPositive);
  const bool wheel = reader.choice("odometry", "perfect", {"perfect", "wheel"}) == "wheel";
  parameters.odometry = wheel ? OdometryOwner::kWheel : OdometryOwner::kPerfect;
  parameters.record_file = reader.text("record", "");
  return parameters;
}

std::string parseResultFile(const std::string & name, const XmlRpc::XmlRpcValue & all)
{
  return ParameterReader(name, all, kNodeKeys).text("result_file", "");
}
}  // namespace f1tenth_sim2d
