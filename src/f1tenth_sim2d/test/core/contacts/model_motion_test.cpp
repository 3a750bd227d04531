// How models move that were given a velocity: how far, through what, against what.
#include <gtest/gtest.h>

#include <cmath>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
namespace
{
ModelDescription onIce(ModelDescription model)
{
  model.solids[0].mu = 0.0;
  return model;
}

ModelState movingAt(double x, double speed)
{
  return {{x, 0.0, 0.0}, {speed, 0.0}, 0.0};
}

/// A plate of 10 mm across the x axis.
Solid plate(const std::string & name)
{
  return box(name + "::link::collision", 0.01, 1.0, 0.5, 0, 0, 0.25);
}
}  // namespace

TEST(ModelMotion, FastModelsGoAsFarAsTheirSpeedSays)
{
  Simulation simulation(world({onIce(movableBox("crate", 0.2, 0.0, 0.0))}));
  simulation.placeModel(0, movingAt(0.0, 12.0));
  simulation.advanceTo(500'000'000);
  EXPECT_NEAR(simulation.modelPose("crate").x, 6.0, 0.05);
}

TEST(ModelMotion, FastThinModelsDoNotPassThroughThinWalls)
{
  ModelDescription disc = onIce(movableBox("disc", 0.2, 0.0, 0.0));
  disc.solids = {plate("disc")};
  disc.solids[0].mu = 0.0;
  ModelDescription wall = staticModel("wall", plate("wall"));
  wall.pose = Pose3(2.0, 0, 0, 0, 0, 0);
  for (int i = 0; i < 8; ++i) {
    Simulation simulation(world({disc, wall}));
    simulation.placeModel(0, movingAt(0.005 * i, 40.0));
    simulation.advanceTo(200'000'000);
    EXPECT_LT(simulation.modelPose("disc").x, 2.0) << "from " << 0.005 * i;
  }
}

TEST(ModelMotion, HeavyModelsPushLightOnesOn)
{
  ModelDescription heavy = onIce(movableBox("heavy", 0.2, 0.0, 0.0));
  heavy.mass = 4.0;
  Simulation simulation(world({heavy, onIce(movableBox("light", 0.2, 0.5, 0.0))}));
  simulation.placeModel(0, movingAt(0.0, 2.0));
  simulation.advanceTo(1'000'000'000);
  // Both go on with 2 m/s * 4 kg / 5 kg after 0.3 m.
  EXPECT_NEAR(simulation.modelPose("light").x, 0.5 + 1.6 * (1.0 - 0.3 / 2.0), 0.02);
}

TEST(ModelMotion, ModelsTurnAboutTheirCentreOfMass)
{
  ModelDescription crate = onIce(movableBox("crate", 0.2, 1.0, 0.0));
  crate.centre_of_mass = {0.5, 0.0};
  Simulation simulation(world({crate}));
  // Its origin moves so that its centre of mass, at (1.5, 0), stands still.
  simulation.placeModel(0, {{1.0, 0.0, 0.0}, {0.0, -0.5 * M_PI}, M_PI});
  simulation.advanceTo(1'000'000'000);
  const Pose2 pose = simulation.modelPose("crate");
  EXPECT_NEAR(pose.x, 2.0, 0.01);
  EXPECT_NEAR(pose.y, 0.0, 0.01);
  EXPECT_NEAR(pose.yaw, M_PI, 0.01);
}

TEST(ModelMotion, ModelsSlideFartherWhereGravityIsLess)
{
  WorldDescription moon = world({movableBox("crate", 0.2, 0.0, 0.0)});
  moon.gravity = 1.62;
  Simulation simulation(moon);
  simulation.placeModel(0, movingAt(0.0, 2.0));
  simulation.advanceTo(4'000'000'000);
  EXPECT_NEAR(simulation.modelPose("crate").x, 2.0 * 2.0 / (2.0 * 0.5 * 1.62), 0.05);
}
}  // namespace f1tenth_sim2d::test
