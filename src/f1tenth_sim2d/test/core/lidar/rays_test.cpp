#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/math/noise.h"
#include "sample_world.h"

// Rays in any direction from any point of a car.
namespace f1tenth_sim2d::test
{
namespace
{
ModelDescription pillar(const std::string & name, bool is_static, double radius, double x, double y)
{
  ModelDescription model = movableBox(name, 2.0 * radius, x, y);
  model.is_static = is_static;
  model.solids[0].shape = Cylinder{radius, 2.0};
  return model;
}

/// Walls, pillars and crates in a room, and one wall that reaches over many cells of the grid.
WorldDescription scenery(std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  std::uniform_real_distribution<double> size(0.05, 0.8);
  std::vector<ModelDescription> models{room(10.0)};
  for (int i = 0; i < 60; ++i) {
    const std::string name = "thing" + std::to_string(i);
    const double x = place(random);
    const double y = place(random);
    if (std::hypot(x, y) < 1.5) {
      continue;
    }
    if (i % 3 == 0) {
      models.push_back(pillar(name, i % 2 == 0, size(random), x, y));
    } else {
      ModelDescription crate = movableBox(name, size(random), x, y);
      crate.is_static = i % 2 == 0;
      crate.pose = Pose3(x, y, 0, 0, 0, place(random));
      models.push_back(crate);
    }
  }
  models.push_back(staticModel("long", box("long::l::c", 12.0, 0.02, 1.0, 0.0, 9.5, 0.5)));
  return world(models);
}

double onlyRay(const Simulation & simulation, CarId car, const Pose2 & origin, double height, double range_max = 100.0)
{
  double range = 0.0;
  simulation.castRays(car, {origin, height, {0.0}, range_max}, &range);
  return range;
}
}  // namespace

class RaysInScenery : public ::testing::TestWithParam<std::uint32_t>
{
};

TEST_P(RaysInScenery, MeetWhatTheBeamsOfALidarMeet)
{
  Simulation simulation(scenery(GetParam()));
  CarDescription description = car("robot1");
  LidarDescription & lidar = description.lidars[0];
  lidar.angle_min = -3.1;
  lidar.angle_max = 3.1;
  lidar.range_min = 0.0;
  lidar.range_max = 30.0;
  simulation.addCar(description, {}, {0.0, 0.0, 0.3 * GetParam()});
  simulation.addCar(car("robot2"), {}, {0.6, -0.9, 0.4});
  RayFan fan{{0.27, 0.0, 0.0}, 0.11, {}, 30.0};
  for (int i = 0; i < lidar.beam_count; ++i) {
    fan.directions.push_back(lidar.angle_min + i * (lidar.angle_max - lidar.angle_min) / (lidar.beam_count - 1));
  }
  std::vector<double> ranges(fan.directions.size());
  std::vector<float> beams(fan.directions.size());
  simulation.castRays(kRobot1, fan, ranges.data());
  simulation.exactScan(kRobot1, 0, beams.data());
  int corners = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (std::abs(ranges[i] - beams[i]) > 1e-5 * ranges[i]) {
      ++corners;  // a direction in another rounding may pass by a corner
    }
  }
  EXPECT_LE(corners, 1);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RaysInScenery, ::testing::Range(1U, 13U));

TEST(Rays, AreExactInAnyDirectionFromAnyPoint)
{
  Simulation simulation(world({room(5.0)}));
  simulation.addCar(car("robot1"), {}, {1.0, 0.5, 0.4});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Pose2 origin{any(random), any(random), 4.0 * any(random)};
    const double range = onlyRay(simulation, kRobot1, origin, 0.3);
    const double x = 1.0 + std::cos(0.4) * origin.x - std::sin(0.4) * origin.y;
    const double y = 0.5 + std::sin(0.4) * origin.x + std::cos(0.4) * origin.y;
    const double heading = 0.4 + origin.yaw;
    const double to_x = ((std::cos(heading) > 0 ? 5.0 : -5.0) - x) / std::cos(heading);
    const double to_y = ((std::sin(heading) > 0 ? 5.0 : -5.0) - y) / std::sin(heading);
    ASSERT_NEAR(range, std::min(to_x, to_y), 1e-9);
  }
}

TEST(Rays, LookAtTheirHeight)
{
  Simulation simulation(world({staticModel("table", box("table::l::c", 1.0, 1.0, 0.1, 2.0, 0.0, 0.75))}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(onlyRay(simulation, kRobot1, {}, 0.3), kInfinity);
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.75), 1.5, 1e-9);
}

TEST(Rays, EndAtTheirRange)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.3, 2.1), 2.0, 1e-9);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {}, 0.3, 1.9), kInfinity);
}

TEST(Rays, SeeOtherCarsButNotTheirOwn)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {2.0, 0.0, 0.0});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.07), 2.0 - 0.1, 1e-9);
  EXPECT_NEAR(onlyRay(simulation, kRobot2, {0.0, 0.0, M_PI}, 0.07), 2.0 - 0.4, 1e-9);
}

TEST(Rays, FollowWhatMoves)
{
  Simulation simulation(world({movableBox("crate", 0.4, 2.0, 0.0)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.2), 1.8, 1e-6);
  simulation.placeModel(0, {{3.0, 0.0, 0.0}, {}, 0.0});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.2), 2.8, 1e-6);
  simulation.removeModel(0);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {}, 0.2), kInfinity);
}

TEST(Rays, FromOutsideTheGridOfWallsFindThem)
{
  Simulation simulation(world({room(2.0)}));
  simulation.addCar(car("robot1"), {}, {-30.0, 1.0, 0.0});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.3), 30.0 - 2.15, 1e-9);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {0.0, 0.0, M_PI}, 0.3), kInfinity);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {0.0, 5.0, 0.0}, 0.3), kInfinity);
}

TEST(Rays, AlongAWallDoNotMeetItAndThroughACornerDo)
{
  Simulation simulation(world({staticModel("block", box("block::l::c", 1.0, 1.0, 1.0, 3.0, 0.5, 0.5))}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {0.0, 0.0, 0.0}, 0.3), 2.5, 1e-9);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {3.0, 0.0, 0.0}, 0.3), kInfinity);
}

TEST(Rays, MeetACircleOnlyFromOutside)
{
  Simulation simulation(world({pillar("pillar", true, 1.0, 5.0, 0.6)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.3), 5.0 - 0.8, 1e-9);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {5.0, 0.5, 0.0}, 0.3), kInfinity);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {8.0, 0.0, 0.0}, 0.3), kInfinity) << "behind it";
}

TEST(Rays, WithoutLimitSeeTheFarthestWall)
{
  Simulation simulation(world({wallAcross(2000.0)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_NEAR(onlyRay(simulation, kRobot1, {}, 0.3, kInfinity), 2000.0, 1e-6);
  EXPECT_EQ(onlyRay(simulation, kRobot1, {0.0, 0.0, M_PI}, 0.3, kInfinity), kInfinity);
}

TEST(SensorNoise, DependsOnCarSensorTimeAndIndexOnly)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {2.0, 0.0, 0.0});
  const double first = simulation.noise(kRobot1, "sonar", 0);
  EXPECT_EQ(simulation.noise(kRobot1, "sonar", 0), first);
  EXPECT_NE(simulation.noise(kRobot1, "sonar", 1), first);
  EXPECT_NE(simulation.noise(kRobot1, "other", 0), first);
  EXPECT_NE(simulation.noise(kRobot2, "sonar", 0), first);
  simulation.step();
  EXPECT_NE(simulation.noise(kRobot1, "sonar", 0), first);
  simulation.reset();
  EXPECT_EQ(simulation.noise(kRobot1, "sonar", 0), first);
}

TEST(SensorNoise, NamesAreHashedByFnv)
{
  EXPECT_EQ(hashOf(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8ULL);
}
}  // namespace f1tenth_sim2d::test
