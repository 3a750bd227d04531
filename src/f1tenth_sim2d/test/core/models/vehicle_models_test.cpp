#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "sample_world.h"

// What every vehicle model does, driven through the whole simulation.
namespace f1tenth_sim2d::test
{
namespace
{
std::vector<VehicleModel> everyModel()
{
  std::vector<VehicleModel> models;
  for (std::size_t i = 0; i < kVehicleModelNames.size(); ++i) {
    models.push_back(static_cast<VehicleModel>(i));
  }
  return models;
}

VehicleParameters withModel(VehicleModel model)
{
  VehicleParameters parameters;
  parameters.model = model;
  parameters.odometry_speed_noise_stddev = 0.0;
  parameters.odometry_steering_noise_stddev = 0.0;
  return parameters;
}

std::string hashOfBumping(Simulation & simulation)
{
  TrajectoryHash hash;
  for (int i = 0; i < 120; ++i) {
    simulation.command(kRobot1, {i < 80 ? 4.0 : -2.0, i % 40 < 20 ? 0.2 : -0.2});
    simulation.advanceTo(simulation.time() + 25'000'000);
    hash.add(simulation);
  }
  return hash.hexDigest();
}

double speedOf(const CarState & state)
{
  return std::hypot(state.velocity.x, state.velocity.y);
}
}  // namespace

class EveryModel : public ::testing::TestWithParam<VehicleModel>
{
protected:
  const VehicleParameters parameters_ = withModel(GetParam());
};

TEST_P(EveryModel, DrivesAheadAtTheCommandedSpeed)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters_, {});
  drive(simulation, kRobot1, {3.0, 0.0}, 3.0);
  const CarState state = simulation.state(kRobot1);
  EXPECT_NEAR(state.velocity.x, 3.0, 0.05);
  EXPECT_NEAR(state.pose.y, 0.0, 0.05);
  EXPECT_NEAR(state.wheel_speeds[2], 3.0 / 0.05, 1.5);
}

TEST_P(EveryModel, TurnsAsItsWheelsPointWhereItIsSlow)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters_, {});
  drive(simulation, kRobot1, {0.8, 0.3}, 3.0);
  const CarState state = simulation.state(kRobot1);
  EXPECT_NEAR(state.yaw_rate, state.velocity.x * std::tan(0.3) / parameters_.wheelbase(), 0.06);
  EXPECT_NEAR(state.steering_angle, 0.3, 1e-9);
}

TEST_P(EveryModel, StandsStillWhenToldTo)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters_, {});
  drive(simulation, kRobot1, {2.0, 0.2}, 1.0);
  drive(simulation, kRobot1, {0.0, 0.2}, 3.0);
  const CarState state = simulation.state(kRobot1);
  EXPECT_EQ(state.velocity.x, 0.0);
  EXPECT_EQ(state.velocity.y, 0.0);
  EXPECT_EQ(state.yaw_rate, 0.0);
  EXPECT_EQ(state.wheel_speeds[0], 0.0);
}

TEST_P(EveryModel, DrivesBackwards)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters_, {});
  drive(simulation, kRobot1, {-1.0, 0.1}, 2.0);
  const CarState state = simulation.state(kRobot1);
  EXPECT_NEAR(state.velocity.x, -1.0, 0.05);
  EXPECT_LT(state.yaw_rate, -0.1);
  EXPECT_LT(state.wheel_speeds[3], -15.0);
}

TEST_P(EveryModel, WheelOdometryFollowsTheWheels)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters_, {1.0, 2.0, 0.5});
  drive(simulation, kRobot1, {1.0, 0.1}, 2.0);
  const CarState state = simulation.state(kRobot1);
  const WheelOdometry odometry = simulation.wheelOdometry(kRobot1);
  EXPECT_NEAR(odometry.pose.x, state.pose.x, 0.05);
  EXPECT_NEAR(odometry.pose.y, state.pose.y, 0.05);
  EXPECT_NEAR(odometry.speed, 1.0, 0.05);
}

TEST_P(EveryModel, IsStoppedByAWall)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), parameters_, {});
  drive(simulation, kRobot1, {3.0, 0.0}, 3.0);
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_LT(simulation.state(kRobot1).pose.x, 1.61);
  EXPECT_LT(speedOf(simulation.state(kRobot1)), 0.2);
}

TEST_P(EveryModel, MovesOnWithTheVelocityThatItIsPlacedWith)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters_, {});
  drive(simulation, kRobot1, {4.0, 0.0}, 1.0);
  simulation.placeCar(kRobot1, {5.0, 5.0, 0.0}, {4.0, 0.0}, 0.0);
  simulation.step();
  const CarState state = simulation.state(kRobot1);
  EXPECT_NEAR(state.velocity.x, 4.0, 0.1);
  EXPECT_NEAR(state.wheel_speeds[2], 4.0 / 0.05, 2.0);
  EXPECT_NEAR(state.pose.x, 5.004, 1e-3);
}

TEST_P(EveryModel, ResetIsAsFresh)
{
  const WorldDescription description = world({room(2.0), movableBox("crate", 0.2, 1.0, 0.1)});
  Simulation simulation(description);
  simulation.addCar(car("robot1"), parameters_, {});
  const std::string first = hashOfBumping(simulation);
  const std::array<double, 4> wheels = simulation.state(kRobot1).wheel_speeds;
  simulation.reset();
  EXPECT_EQ(hashOfBumping(simulation), first);
  EXPECT_EQ(simulation.state(kRobot1).wheel_speeds, wheels);
  Simulation fresh(description);
  fresh.addCar(car("robot1"), parameters_, {});
  EXPECT_EQ(hashOfBumping(fresh), first);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(everyModel()), [](const auto & model) {
  return kVehicleModelNames[static_cast<std::size_t>(model.param)];
});

TEST(VehicleModels, EachDrivesATrackOfItsOwn)
{
  std::set<std::string> hashes;
  for (const VehicleModel model : everyModel()) {
    Simulation simulation(world());
    simulation.addCar(car("robot1"), withModel(model), {});
    hashes.insert(hashOfBumping(simulation));
  }
  EXPECT_EQ(hashes.size(), everyModel().size());
}

TEST(VehicleModels, KinematicCarDoesNotSlip)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), withModel(VehicleModel::kKinematic), {});
  drive(simulation, kRobot1, {8.0, 0.2}, 3.0);
  const CarState state = simulation.state(kRobot1);
  EXPECT_NEAR(state.velocity.y, 0.0, 1e-9) << "of the rear axle";
  EXPECT_NEAR(state.yaw_rate, state.velocity.x * std::tan(0.2) / VehicleParameters{}.wheelbase(), 1e-9);
}

TEST(VehicleModels, OnlyTheDriftModelKeepsToFrictionInACorner)
{
  const auto lateral = [](VehicleModel model) {
    Simulation simulation(world());
    simulation.addCar(car("robot1"), withModel(model), {});
    drive(simulation, kRobot1, {8.0, 0.0}, 2.0);
    double strongest = 0.0;
    for (int i = 0; i < 500; ++i) {
      drive(simulation, kRobot1, {8.0, 0.2}, 0.001);
      strongest = std::max(strongest, std::abs(simulation.state(kRobot1).acceleration.y));
    }
    return strongest / (VehicleParameters{}.mu * 9.81);
  };
  EXPECT_GT(lateral(VehicleModel::kSingleTrack), 1.9);
  EXPECT_LT(lateral(VehicleModel::kSingleTrackDrift), 1.1);
  EXPECT_GT(lateral(VehicleModel::kSingleTrackDrift), 0.85);
}

TEST(VehicleModels, OdometryOfACarWhoseWheelsSpinGoesTooFar)
{
  VehicleParameters parameters = withModel(VehicleModel::kSingleTrackDrift);
  parameters.mu = 0.1;
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters, {});
  drive(simulation, kRobot1, {5.0, 0.0}, 1.0);
  const CarState state = simulation.state(kRobot1);
  EXPECT_GT(simulation.wheelOdometry(kRobot1).pose.x, 2.0 * state.pose.x);
  EXPECT_GT(state.wheel_speeds[0] * 0.05, 2.0 * state.velocity.x);
  EXPECT_LT(state.wheel_speeds[0] * 0.05, 6.0) << "the motor holds the wheels at the commanded speed";
}

TEST(VehicleModels, CarThatIsPlacedAtASpeedFeelsNoJolt)
{
  for (const VehicleModel model : everyModel()) {
    VehicleParameters parameters = withModel(model);
    parameters.actuation_latency = 0.0;
    Simulation simulation(world());
    simulation.addCar(car("robot1"), parameters, {});
    simulation.placeCar(kRobot1, {}, {5.0, 0.0});
    EXPECT_NEAR(simulation.state(kRobot1).wheel_speeds[2], 5.0 / 0.05, 1e-9);
    simulation.command(kRobot1, {5.0, 0.0});
    simulation.step();
    EXPECT_LT(std::abs(simulation.state(kRobot1).acceleration.x), 1.0);
    simulation.advanceTo(20'000'000);
    EXPECT_NEAR(simulation.wheelOdometry(kRobot1).pose.x, simulation.state(kRobot1).pose.x, 1e-4);
  }
}

TEST(VehicleModels, WheelsThatNoFormulaFitsAreRefused)
{
  Simulation simulation(world());
  const auto refusal = [&](double VehicleParameters::*member, double value) -> std::string {
    VehicleParameters parameters = withModel(VehicleModel::kSingleTrackDrift);
    parameters.*member = value;
    try {
      simulation.addCar(car("robot1"), parameters, {});
    } catch (const Error & error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(&VehicleParameters::R_w, 0.0), "robot1: R_w (m) is 0, allowed is 0.001 to 100");
  EXPECT_EQ(refusal(&VehicleParameters::mu, 0.0), "robot1: mu is 0, allowed is 0.001 to 10");
  EXPECT_EQ(refusal(&VehicleParameters::T_se, 1.5), "robot1: T_se is 1.5, allowed are numbers from 0 to 1");
  EXPECT_EQ(
    refusal(&VehicleParameters::I_y_w, std::numeric_limits<double>::quiet_NaN()),
    "robot1: I_y_w (kg m^2) is nan, allowed is 1e-09 to 1e+12");
}
}  // namespace f1tenth_sim2d::test
