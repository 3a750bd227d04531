#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "f1tenth_sim2d/errors.h"
#include "sample_world.h"

namespace f1tenth_sim2d::test
{
TEST(Movable, BoxIsPushedAndComesToAnExactStop)
{
  Simulation simulation(world({movableBox("crate", 0.2, 1.5, 0.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 1.2);
  EXPECT_GT(simulation.modelPose("crate").x, 1.55);
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_model, "crate");
  drive(simulation, kRobot1, {0.0, 0.0}, 3.0);
  const Pose2 stopped = simulation.modelPose("crate");
  drive(simulation, kRobot1, {0.0, 0.0}, 1.0);
  EXPECT_EQ(simulation.modelPose("crate").x, stopped.x);
  EXPECT_EQ(simulation.modelPose("crate").yaw, stopped.yaw);
}

TEST(Movable, SlidesAsFarAsFrictionLetsIt)
{
  ModelDescription crate = movableBox("crate", 0.2, 1.2, 0.0);
  Simulation simulation(world({crate}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {3.0, 0.0}, 0.4);
  while (simulation.contacts(kRobot1).empty()) {
    drive(simulation, kRobot1, {3.0, 0.0}, 0.001);
  }
  double last = simulation.modelPose("crate").x;
  drive(simulation, kRobot1, {0.0, 0.0}, 0.05);
  double position = simulation.modelPose("crate").x;
  drive(simulation, kRobot1, {-3.0, 0.0}, 0.001);
  const double speed = (simulation.modelPose("crate").x - position) / 0.001;
  position = simulation.modelPose("crate").x;
  drive(simulation, kRobot1, {-3.0, 0.0}, 2.0);
  const double distance = simulation.modelPose("crate").x - position;
  EXPECT_GT(position, last);
  EXPECT_GT(speed, 0.5);
  EXPECT_NEAR(distance, speed * speed / (2.0 * 0.5 * 9.8), 0.1 * distance);
}

TEST(Movable, HeavyBoxHoldsAgainstAGentlePush)
{
  ModelDescription safe = movableBox("safe", 0.4, 1.0, 0.0);
  safe.mass = 50.0;
  safe.inertia_zz = 1.0;
  Simulation simulation(world({safe}));
  simulation.addCar(car("robot1"), {}, {0.35, 0, 0});
  drive(simulation, kRobot1, {0.3, 0.0}, 3.0);
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_NEAR(simulation.modelPose("safe").x, 1.0, 0.003);
}

TEST(Movable, BoxIsPushedAgainstAWallAndStaysThere)
{
  Simulation simulation(world({movableBox("crate", 0.2, 1.5, 0.0), wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 3.0);
  EXPECT_NEAR(simulation.modelPose("crate").x, 1.9, 0.01);
  EXPECT_NEAR(simulation.state(kRobot1).pose.x + 0.4, 1.8, 0.02);
}

TEST(Movable, CrateTurnsWhenItIsHitOffItsCentre)
{
  Simulation simulation(world({movableBox("crate", 0.2, 1.5, 0.15)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 1.5);
  EXPECT_GT(std::abs(simulation.modelPose("crate").yaw), 0.05);
}

TEST(Movable, CentreOfMassNeedNotBeTheOrigin)
{
  ModelDescription crate = movableBox("crate", 0.2, 1.5, 0.0);
  crate.pose = Pose3(1.4, 0.1, 0, 0, 0, 0.5);
  crate.centre_of_mass = {0.1, -0.05};
  Simulation simulation(world({crate}));
  EXPECT_EQ(simulation.modelPose("crate").x, 1.4);
  EXPECT_DOUBLE_EQ(simulation.modelPose("crate").yaw, 0.5);
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 1.0);
  EXPECT_GT(simulation.modelPose("crate").x, 1.41);
}

TEST(Movable, WorldAtRestIsNotAdvanced)
{
  Simulation simulation(world({movableBox("crate", 0.2, 1.5, 0.0), movableBox("other", 0.2, 1.65, 0.1)}));
  simulation.addCar(car("robot1"), {}, {-2, 0, 0});
  drive(simulation, kRobot1, {-1.0, 0.0}, 1.0);
  EXPECT_EQ(simulation.modelPose("crate").x, 1.5) << "models that overlap at the start stay until they are touched";
}

TEST(Clearance, IsTheExactLeastDistance)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(simulation.clearance(kRobot1, 5.0), 1.6, 1e-5);
  EXPECT_EQ(simulation.clearance(kRobot1, 1.0), 1.0);
  simulation.addCar(car("robot2"), {}, {0.0, -0.75, 0.0});
  EXPECT_NEAR(simulation.clearance(kRobot1, 5.0), 0.5, 1e-5);
  EXPECT_NEAR(simulation.clearance(kRobot2, 5.0), 0.5, 1e-5);
}

TEST(Clearance, RefusesALimitThatIsNone)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  for (const double limit : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(simulation.clearance(kRobot1, limit), Error) << limit;
  }
  EXPECT_NEAR(simulation.clearance(kRobot1, std::numeric_limits<double>::infinity()), 1.6, 1e-5);
}

TEST(Clearance, LooksAtMovableModelsAndRoundOnes)
{
  Solid pillar{"pillar::link::collision", Cylinder{0.3, 2.0}, Pose3(0.15, 1.425, 1, 0, 0, 0)};
  Simulation simulation(world({movableBox("crate", 0.2, 1.5, 0.0), staticModel("pillar", pillar)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(simulation.clearance(kRobot1, 5.0), 1.0, 1e-5);
  drive(simulation, kRobot1, {0.5, 0.0}, 1.0);
  const double x = simulation.state(kRobot1).pose.x;
  EXPECT_NEAR(simulation.clearance(kRobot1, 5.0), 1.4 - 0.4 - x, 1e-4);
}

TEST(Clearance, DoesNotCountWhatTheCarFitsUnder)
{
  Simulation simulation(world({staticModel("shelf", box("shelf::l::c", 2, 2, 0.04, 0, 0, 0.7))}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(simulation.clearance(kRobot1, 5.0), 5.0);
}
}  // namespace f1tenth_sim2d::test
