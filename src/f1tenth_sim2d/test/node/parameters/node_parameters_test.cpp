#include "node/parameters/node_parameters.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

using namespace f1tenth_sim2d;
using XmlRpc::XmlRpcValue;

namespace
{
XmlRpcValue minimal()
{
  XmlRpcValue value;
  value["world"] = "circuit1.world";
  value["cars"]["robot1"]["x"] = 1;
  return value;
}

std::string errorOf(const std::function<void(XmlRpcValue &)> & change)
{
  XmlRpcValue value = minimal();
  change(value);
  try {
    parseNodeParameters("/sim2d", value);
  } catch (const workspace_support::OptionError & error) {
    return error.what();
  }
  return "no error";
}

/// Error for one wrong parameter.
template <class Value>
std::string errorFor(const std::string & key, const Value & wrong)
{
  return errorOf([&](XmlRpcValue & value) { value[key] = wrong; });
}

XmlRpcValue list(const std::vector<XmlRpcValue> & entries)
{
  XmlRpcValue value;
  value.setSize(static_cast<int>(entries.size()));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    value[static_cast<int>(i)] = entries[i];
  }
  return value;
}
}  // namespace

TEST(NodeParameters, ReadmeNamesEachParameterAndNoOther)
{
  std::ifstream readme(F1TENTH_SIM2D_README);
  std::string table;
  std::string line;
  while (std::getline(readme, line) && line != "## The node sim2d") {
  }
  while (std::getline(readme, line) && line != "### Topics") {
    const std::size_t end = line.find("` |");
    if (line.rfind("| `", 0) == 0 && end != std::string::npos) {
      table += (table.empty() ? "" : ", ") + line.substr(3, end - 3);
    }
  }
  EXPECT_EQ(errorFor("no_such", 1), "parameter /sim2d/no_such: unknown; allowed: " + table);
}

TEST(NodeParameters, DefaultsAreThoseOfTheDocumentation)
{
  const auto parameters = parseNodeParameters("/sim2d", minimal());
  EXPECT_EQ(parameters.world_file, "circuit1.world");
  EXPECT_FALSE(parameters.is_lockstep);
  EXPECT_EQ(parameters.real_time_factor, 1.0);
  EXPECT_TRUE(parameters.lockstep.participants.empty());
  EXPECT_EQ(parameters.lockstep.timeout_sec, 5.0);
  EXPECT_EQ(parameters.lockstep.startup_timeout_sec, 60.0);
  EXPECT_EQ(parameters.control_period_sec, 0.025);
  EXPECT_EQ(parameters.simulation.physics_step, 0.001);
  EXPECT_EQ(parameters.simulation.seed, 0u);
  EXPECT_EQ(parameters.clock_rate_hz, 200.0);
  EXPECT_EQ(parameters.odometry, OdometryOwner::kPerfect);
  EXPECT_EQ(parameters.record_file, "");
  ASSERT_EQ(parameters.cars.size(), 1u);
  EXPECT_EQ(parameters.cars[0].name, "robot1");
  EXPECT_EQ(parameters.cars[0].pose.value().x, 1.0);
  EXPECT_EQ(parameters.cars[0].vehicle_file, "");
  EXPECT_EQ(parameters.cars[0].frame_prefix, "robot1/");
}

TEST(NodeParameters, FactorMayBeZeroAlsoInLockstep)
{
  XmlRpcValue value = minimal();
  value["real_time_factor"] = 0;
  EXPECT_EQ(parseNodeParameters("/sim2d", value).real_time_factor, 0.0);
  value["lockstep"] = true;
  EXPECT_TRUE(parseNodeParameters("/sim2d", value).is_lockstep);
}

TEST(NodeParameters, ReadsEverythingThatIsThere)
{
  XmlRpcValue value = minimal();
  value["participants"] = list({"robot1", "robot1/race_mgr"});
  value["seed"] = 7;
  value["odometry"] = "wheel";
  value["cars"]["robot1"]["yaw"] = 0.5;
  value["cars"]["robot1"]["frame_prefix"] = "";
  value["cars"]["robot1"]["vehicle"] = "car.yaml";
  const auto parameters = parseNodeParameters("/sim2d", value);
  EXPECT_EQ(parameters.lockstep.participants, (std::vector<std::string>{"robot1", "robot1/race_mgr"}));
  EXPECT_EQ(parameters.simulation.seed, 7u);
  EXPECT_EQ(parameters.odometry, OdometryOwner::kWheel);
  EXPECT_EQ(parameters.cars[0].pose.value().yaw, 0.5);
  EXPECT_EQ(parameters.cars[0].frame_prefix, "");
  EXPECT_EQ(parameters.cars[0].vehicle_file, "car.yaml");
}

TEST(NodeParameters, CarWithoutAPoseStartsWhereTheWorldSays)
{
  XmlRpcValue value;
  value["world"] = "a.world";
  value["cars"]["robot1"]["frame_prefix"] = "";
  EXPECT_FALSE(parseNodeParameters("/sim2d", value).cars[0].pose.has_value());
}

TEST(NodeParameters, AStartIsOneInTheWorldUnlessItIsSaidToBeRelative)
{
  XmlRpcValue value = minimal();
  value["cars"]["robot1"]["y"] = 0.5;
  value["cars"]["robot1"]["yaw"] = 0.25;
  const Pose2 world_start{10.0, 20.0, std::acos(0.0)};
  const Pose2 absolute = startPose(parseNodeParameters("/sim2d", value).cars[0], world_start);
  EXPECT_EQ(absolute.x, 1.0);
  EXPECT_EQ(absolute.y, 0.5);
  EXPECT_EQ(absolute.yaw, 0.25);
  value["cars"]["robot1"]["relative_to_start"] = true;
  const Pose2 relative = startPose(parseNodeParameters("/sim2d", value).cars[0], world_start);
  EXPECT_NEAR(relative.x, 9.5, 1e-12);
  EXPECT_NEAR(relative.y, 21.0, 1e-12);
  EXPECT_NEAR(relative.yaw, world_start.yaw + 0.25, 1e-12);
}

TEST(NodeParameters, RefusesUnknownKeysNamingTheAllowedOnes)
{
  EXPECT_EQ(
    errorFor("wrld", "x"),
    "parameter /sim2d/wrld: unknown; allowed: world, cars, real_time_factor, lockstep, participants, "
    "lockstep_timeout, lockstep_startup_timeout, paused, clock_rate, "
    "physics_step, control_period, seed, odometry, record, interventions, result_file");
  EXPECT_EQ(
    errorOf([](XmlRpcValue & value) { value["cars"]["robot1"]["z"] = 0.0; }),
    "parameter /sim2d/cars/robot1/z: unknown; allowed: x, y, yaw, relative_to_start, vehicle, "
    "frame_prefix");
}

TEST(NodeParameters, CarsMayComeLater)
{
  XmlRpcValue value;
  value["world"] = "w";
  EXPECT_TRUE(parseNodeParameters("/sim2d", value).cars.empty());
}

TEST(NodeParameters, NamesWhatIsMissing)
{
  EXPECT_EQ(
    errorOf([](XmlRpcValue & value) { value = XmlRpcValue(); }),
    "parameter /sim2d/world: not set, must be a text that is not empty");
}

TEST(NodeParameters, RefusesWrongNumbers)
{
  EXPECT_EQ(
    errorFor("real_time_factor", -1.0),
    "parameter /sim2d/real_time_factor: found -1, must be a number that is 0 (as fast as it goes) or >= 1e-06");
  EXPECT_EQ(
    errorFor("real_time_factor", "fast"),
    "parameter /sim2d/real_time_factor: found \"fast\", must be a number that is 0 (as fast as it goes) or >= 1e-06");
  EXPECT_EQ(
    errorFor("lockstep_timeout", 0), "parameter /sim2d/lockstep_timeout: found 0, must be a number > 0 and <= 1e+09");
  EXPECT_EQ(
    errorFor("lockstep_startup_timeout", -2),
    "parameter /sim2d/lockstep_startup_timeout: found -2, must be a number > 0 and <= 1e+09");
  EXPECT_EQ(errorFor("physics_step", 0.0), "parameter /sim2d/physics_step: found 0, must be a number > 0");
  EXPECT_EQ(
    errorFor("clock_rate", true), "parameter /sim2d/clock_rate: found true, must be a number >= 0.001 and <= 1e+06");
  EXPECT_EQ(
    errorFor("control_period", 0.0255),
    "parameter /sim2d/control_period: found 0.0255, must be a number of seconds that is a multiple of physics_step and "
    "<= 1000");
  EXPECT_EQ(errorFor("seed", -3), "parameter /sim2d/seed: found -3, must be a whole number >= 0");
  EXPECT_EQ(errorFor("seed", 1.5), "parameter /sim2d/seed: found 1.5, must be a whole number >= 0");
  EXPECT_EQ(
    errorOf([](XmlRpcValue & value) { value["cars"]["robot1"]["x"] = std::numeric_limits<double>::quiet_NaN(); }),
    "parameter /sim2d/cars/robot1/x: found nan, must be a finite number");
}

TEST(NodeParameters, RefusesNumbersThatTimesCannotHold)
{
  const auto refuses = [](const std::string & key, double value) {
    return errorFor(key, value).rfind("parameter /sim2d/" + key + ": found ", 0) == 0;
  };
  EXPECT_TRUE(refuses("real_time_factor", 1e-13));
  EXPECT_TRUE(refuses("lockstep_timeout", 1e12));
  EXPECT_TRUE(refuses("lockstep_startup_timeout", 1e12));
  EXPECT_TRUE(refuses("clock_rate", 1e-12));
  EXPECT_TRUE(refuses("clock_rate", 1e15));
  EXPECT_TRUE(refuses("control_period", 1e12));
}

TEST(NodeParameters, RefusesWrongTypes)
{
  EXPECT_EQ(errorFor("lockstep", 1), "parameter /sim2d/lockstep: found 1, must be true or false");
  EXPECT_EQ(errorFor("record", 1), "parameter /sim2d/record: found 1, must be a text");
  EXPECT_EQ(errorFor("world", ""), "parameter /sim2d/world: found \"\", must be a text that is not empty");
  EXPECT_EQ(
    errorFor("odometry", "visual"), "parameter /sim2d/odometry: found \"visual\", must be one of perfect, wheel");
  EXPECT_EQ(errorFor("cars", list({"robot1"})), "parameter /sim2d/cars: found a list, must be a map");
  EXPECT_EQ(
    errorOf([](XmlRpcValue & value) { value["cars"]["robot1"] = 3; }),
    "parameter /sim2d/cars/robot1: found 3, must be a map");
}

TEST(NodeParameters, RefusesWrongParticipants)
{
  EXPECT_EQ(
    errorFor("participants", "robot1"), "parameter /sim2d/participants: found \"robot1\", must be a list of names");
  EXPECT_EQ(errorFor("participants", list({"a", 3})), "parameter /sim2d/participants[1]: found 3, must be a name");
  EXPECT_EQ(
    errorFor("participants", list({"a", "a"})),
    "parameter /sim2d/participants[1]: found \"a\" twice, must be a different name");
}

TEST(NodeParameters, RefusesCarsThatCannotBeToldApartOrNamed)
{
  EXPECT_EQ(
    errorOf([](XmlRpcValue & value) { value["cars"]["1st"]["x"] = 0; }),
    "parameter /sim2d/cars/1st: found the car name \"1st\", must be letters, digits and _, a letter first");
  EXPECT_EQ(
    errorOf([](XmlRpcValue & value) { value["cars"]["robot2"]["frame_prefix"] = "robot1/"; }),
    "parameter /sim2d/cars/robot2/frame_prefix: found \"robot1/\" twice, must be a different one for each car");
}

TEST(NodeParameters, ResultFileIsReadApart)
{
  XmlRpcValue value = minimal();
  EXPECT_EQ(parseResultFile("/sim2d", value), "");
  value["result_file"] = "result.json";
  value["seed"] = -1;
  EXPECT_EQ(parseResultFile("/sim2d", value), "result.json");
}
