#include <gtest/gtest.h>

#include <vector>

#include "allocation_count.h"
#include "sample_world.h"

namespace f1tenth_sim2d::test
{
TEST(Allocation, ScanningAllocatesNothing)
{
  Simulation simulation(world({room(3.0), movableBox("crate", 0.3, 1.5, 0.0)}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {0, 1, 0});
  std::vector<float> ranges(1081);
  simulation.scan(kRobot1, 0, ranges.data());
  simulation.step();
  const std::size_t before = allocationCount();
  simulation.scan(kRobot1, 0, ranges.data());
  simulation.exactScan(kRobot2, 0, ranges.data());
  EXPECT_EQ(allocationCount(), before);
}

TEST(Allocation, CastingRaysAllocatesNothingAfterTheFirstTimeAtAHeight)
{
  Simulation simulation(world({room(3.0), movableBox("crate", 0.3, 1.5, 0.0)}));
  simulation.addCar(car("robot1"), {}, {});
  const RayFan fan{{}, 0.15, {-0.5, 0.0, 1.0, 3.0}, 20.0};
  double ranges[4];
  simulation.castRays(kRobot1, fan, ranges);
  const std::size_t before = allocationCount();
  simulation.castRays(kRobot1, fan, ranges);
  EXPECT_EQ(allocationCount(), before);
}

TEST(Allocation, LongDiagonalWallsAreKeptInTheCellsThatTheyPassThroughOnly)
{
  std::vector<ModelDescription> walls;
  for (int i = 0; i < 20; ++i) {
    walls.push_back(staticModel("wall" + std::to_string(i), box("wall::l::c", 1000.0, 0.2, 1.0, 0.0, 0.0, 0.5)));
    walls.back().pose = Pose3(20.0 * i, 5.0, 0.0, 0.0, 0.0, 0.785);
  }
  const std::size_t before = allocatedBytes();
  Simulation simulation(world(walls));
  simulation.addCar(car("robot1"), {}, {10.0, 0.0, 0.0});
  EXPECT_LT(allocatedBytes() - before, 10'000'000u);
}

TEST(Allocation, SteppingFarFromEverythingAllocatesNothing)
{
  Simulation simulation(world({room(30.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {1.0, 0.1}, 0.5);
  const std::size_t before = allocationCount();
  for (int i = 0; i < 300; ++i) {
    simulation.step();
    simulation.state(kRobot1);
  }
  EXPECT_EQ(allocationCount(), before);
}
}  // namespace f1tenth_sim2d::test
