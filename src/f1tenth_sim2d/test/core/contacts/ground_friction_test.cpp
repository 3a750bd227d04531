// What brakes models that slide over the ground: the smaller coefficient of ground and foot, turning included.
#include <gtest/gtest.h>

#include <cmath>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
constexpr double kGravity = 9.81;  // m/s^2

/// Where a crate at the origin comes to rest that is given a velocity.
Pose2 restOf(const ModelDescription & crate, const std::vector<ModelDescription> & grounds, const ModelState & state)
{
  std::vector<ModelDescription> models{crate};
  models.insert(models.end(), grounds.begin(), grounds.end());
  Simulation simulation(world(models));
  simulation.addCar(car("robot1"), {}, {-5.0, 0.0, 0.0});
  simulation.placeModel(0, state);
  drive(simulation, kRobot1, {0.0, 0.0}, 3.0);
  return simulation.modelPose("crate");
}

ModelState moving(double speed, double yaw_rate)
{
  ModelState state;
  state.velocity = {speed, 0.0};
  state.yaw_rate = yaw_rate;
  return state;
}

ModelDescription ground(const std::string & name, double mu)
{
  ModelDescription model = staticModel(name, {name + "::link::collision", Plane{}, Pose3()});
  model.solids[0].mu = mu;
  return model;
}

double slide(double mu)
{
  return 1.0 / (2.0 * mu * kGravity);  // from 1 m/s
}

TEST(GroundFriction, SolidThatTheModelStandsOnDecides)
{
  ModelDescription crate = movableBox("crate", 0.2, 0.0, 0.0);
  Solid lid = box("crate::link::lid", 0.2, 0.2, 0.02, 0, 0, 0.21);
  lid.mu = 0.1;
  crate.solids.push_back(lid);
  EXPECT_NEAR(restOf(crate, {}, moving(1.0, 0.0)).x, slide(0.5), 0.005);
}

TEST(GroundFriction, MostSlipperyGroundDecides)
{
  const ModelDescription crate = movableBox("crate", 0.2, 0.0, 0.0);
  EXPECT_NEAR(restOf(crate, {ground("ice", 0.2), ground("road", 0.9)}, moving(1.0, 0.0)).x, slide(0.2), 0.005);
}

TEST(GroundFriction, BrakesTurningToo)
{
  const double yaw = restOf(movableBox("crate", 0.2, 0.0, 0.0), {}, moving(0.0, 10.0)).yaw;
  EXPECT_GT(yaw, 0.1);
  EXPECT_LT(yaw, 3.0);
}
}  // namespace f1tenth_sim2d::test
