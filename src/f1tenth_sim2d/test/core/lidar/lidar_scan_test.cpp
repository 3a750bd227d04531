#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
constexpr float kNothing = std::numeric_limits<float>::infinity();

CarDescription carWithSingleBeam(const std::string & name, double angle = 0.0)
{
  CarDescription description = car(name);
  description.lidars[0].beam_count = 1;
  description.lidars[0].angle_min = angle;
  description.lidars[0].angle_max = angle;
  return description;
}

float exactBeam(const Simulation & simulation, CarId car = kRobot1)
{
  float range = 0.0F;
  simulation.exactScan(car, 0, &range);
  return range;
}

TEST(LidarScan, MeasuresFromItsMount)
{
  Simulation simulation(world({wallAcross(3.0)}));
  simulation.addCar(carWithSingleBeam("robot1"), {}, {});
  EXPECT_FLOAT_EQ(exactBeam(simulation), 3.0F - 0.27F);
}

TEST(LidarScan, BeamsRunFromTheLeastToTheLargestAngleBothIncluded)
{
  Simulation simulation(world({room(3.0)}));
  CarDescription description = car("robot1");
  description.lidars[0].pose = Pose3(0, 0, 0.11, 0, 0, 0.5);
  description.lidars[0].beam_count = 3;
  description.lidars[0].angle_min = -0.5;
  description.lidars[0].angle_max = M_PI / 2 - 0.5;
  simulation.addCar(description, {}, {0.5, 0, 0});
  float ranges[3];
  simulation.exactScan(kRobot1, 0, ranges);
  EXPECT_FLOAT_EQ(ranges[0], 2.5F);
  EXPECT_FLOAT_EQ(ranges[1], 2.5F / std::cos(static_cast<float>(M_PI) / 4));
  EXPECT_FLOAT_EQ(ranges[2], 3.0F);
}

TEST(LidarScan, UpsideDownItsBeamsRunClockwise)
{
  Simulation simulation(world({room(3.0)}));
  CarDescription description = car("robot1");
  description.lidars[0].pose = Pose3(0, 0, 0.11, M_PI, 0, 0.5);
  description.lidars[0].beam_count = 3;
  description.lidars[0].angle_min = 0.5 - M_PI / 2;
  description.lidars[0].angle_max = 0.5;
  simulation.addCar(description, {}, {0.5, 0, 0});
  float ranges[3];
  simulation.exactScan(kRobot1, 0, ranges);
  EXPECT_FLOAT_EQ(ranges[0], 3.0F);
  EXPECT_FLOAT_EQ(ranges[1], 2.5F / std::cos(static_cast<float>(M_PI) / 4));
  EXPECT_FLOAT_EQ(ranges[2], 2.5F);
}

TEST(LidarScan, LooksUnderATableAndOverABox)
{
  ModelDescription table = staticModel("table", box("table::top::c", 1, 1, 0.04, 2, 0, 0.72));
  table.solids.push_back(box("table::kerb::c", 1, 1, 0.1, 2, 0, 0.05));
  Simulation simulation(world({table, wallAcross(5.0)}));
  simulation.addCar(carWithSingleBeam("robot1"), {}, {});
  EXPECT_FLOAT_EQ(exactBeam(simulation), 5.0F - 0.27F);
}

TEST(LidarScan, SaysInfinityBeyondItsRangeAndMinusInfinityBelow)
{
  CarDescription description = carWithSingleBeam("robot1");
  description.lidars[0].range_min = 1.0;
  description.lidars[0].range_max = 5.0;
  Simulation simulation(world({wallAcross(5.5)}));
  simulation.addCar(description, {}, {});
  EXPECT_EQ(exactBeam(simulation), kNothing);
  Simulation nearer(world({wallAcross(1.2)}));
  nearer.addCar(description, {}, {});
  EXPECT_EQ(exactBeam(nearer), -kNothing);
  float noisy = 0.0F;
  nearer.scan(kRobot1, 0, &noisy);
  EXPECT_EQ(noisy, -kNothing);
}

TEST(LidarScan, CarsSeeEachOtherButNotThemselves)
{
  Simulation simulation(world());
  simulation.addCar(carWithSingleBeam("robot1"), {}, {});
  simulation.addCar(carWithSingleBeam("robot2", M_PI), {}, {2.0, 0.0, 0.0});
  EXPECT_FLOAT_EQ(exactBeam(simulation, kRobot1), 2.0F - 0.095F - 0.27F)
    << "the chassis; the bumpers end below the lidar";
  EXPECT_FLOAT_EQ(exactBeam(simulation, kRobot2), 2.27F - 0.395F);
  drive(simulation, kRobot2, {1.0, 0.0}, 1.0);
  EXPECT_NEAR(exactBeam(simulation, kRobot1), simulation.state(kRobot2).pose.x - 0.095 - 0.27, 1e-5);
}

TEST(LidarScan, DoesNotSeeWhatOfItsOwnCarStandsBeforeIt)
{
  CarDescription description = carWithSingleBeam("robot1");
  description.solids.push_back(box("car::mast::collision", 0.02, 0.02, 0.3, 0.35, 0, 0.17));
  Simulation simulation(world({wallAcross(3.0)}));
  simulation.addCar(description, {}, {});
  EXPECT_FLOAT_EQ(exactBeam(simulation), 3.0F - 0.27F);
}

TEST(LidarScan, SeesModelsWhereTheyAreNow)
{
  Simulation simulation(world({movableBox("crate", 0.3, 1.5, 0.0)}));
  simulation.addCar(carWithSingleBeam("robot1"), {}, {});
  EXPECT_FLOAT_EQ(exactBeam(simulation), 1.35F - 0.27F);
  drive(simulation, kRobot1, {2.0, 0.0}, 1.0);
  drive(simulation, kRobot1, {-1.0, 0.0}, 1.0);
  const double front = simulation.modelPose("crate").x - 0.15;
  EXPECT_GT(front, 1.4);
  EXPECT_NEAR(exactBeam(simulation), front - simulation.state(kRobot1).pose.x - 0.27, 0.002);
}

TEST(LidarScan, NoiseHasTheStatedMeanAndSigma)
{
  CarDescription description = car("robot1");
  description.lidars[0].noise_mean = 0.02;
  description.lidars[0].noise_stddev = 0.01;
  Simulation simulation(world({room(3.0)}));
  simulation.addCar(description, {}, {});
  std::vector<float> exact(1081);
  std::vector<float> noisy(1081);
  double sum = 0.0;
  double squares = 0.0;
  const int scans = 200;
  for (int i = 0; i < scans; ++i) {
    simulation.step();
    simulation.exactScan(kRobot1, 0, exact.data());
    simulation.scan(kRobot1, 0, noisy.data());
    for (std::size_t beam = 0; beam < exact.size(); ++beam) {
      const double error = static_cast<double>(noisy[beam]) - exact[beam];
      sum += error;
      squares += error * error;
    }
  }
  const double count = scans * 1081.0;
  const double mean = sum / count;
  EXPECT_NEAR(mean, 0.02, 4 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 0.01, 4 * 0.01 / std::sqrt(2 * count));
}

/// What noise adds to scans of a standing car, scan after scan of 1081 beams, in standard deviations.
std::vector<double> noiseOfScans(int scans)
{
  CarDescription description = car("robot1");
  description.lidars[0].noise_stddev = 0.01;
  Simulation simulation(world({room(3.0)}));
  simulation.addCar(description, {}, {});
  std::vector<float> exact(1081);
  std::vector<float> noisy(1081);
  std::vector<double> noise;
  simulation.exactScan(kRobot1, 0, exact.data());
  for (int i = 0; i < scans; ++i) {
    simulation.advanceTo((i + 1) * SimTime{25'000'000});
    simulation.scan(kRobot1, 0, noisy.data());
    for (std::size_t beam = 0; beam < exact.size(); ++beam) {
      noise.push_back((static_cast<double>(noisy[beam]) - exact[beam]) / 0.01);
    }
  }
  return noise;
}

double autocorrelation(const std::vector<double> & values, std::size_t lag)
{
  double sum = 0.0;
  for (std::size_t i = lag; i < values.size(); ++i) {
    sum += values[i] * values[i - lag];
  }
  return sum / static_cast<double>(values.size() - lag);
}

TEST(LidarScan, NoiseIsWhiteAcrossBeamsAndScans)
{
  const std::vector<double> noise = noiseOfScans(400);
  const double bound = 4.0 / std::sqrt(static_cast<double>(noise.size()));
  EXPECT_NEAR(autocorrelation(noise, 0), 1.0, 2 * bound);
  for (const std::size_t beams : {1, 2, 3, 4, 7, 8, 16, 32, 540}) {
    EXPECT_NEAR(autocorrelation(noise, beams), 0.0, bound) << beams << " beams apart";
  }
  for (const std::size_t scans : {1, 2, 3, 8, 40}) {
    EXPECT_NEAR(autocorrelation(noise, 1081 * scans), 0.0, bound) << scans << " scans apart";
  }
}

TEST(LidarScan, NoiseIsAFunctionOfSeedCarLidarAndTime)
{
  CarDescription description = car("robot1");
  description.lidars[0].noise_stddev = 0.01;
  const auto firstScan = [&](std::uint64_t seed, int steps) {
    Simulation simulation(world({room(3.0)}), {0.001, seed});
    simulation.addCar(description, {}, {});
    for (int i = 0; i < steps; ++i) {
      simulation.step();
    }
    std::vector<float> ranges(1081);
    simulation.scan(kRobot1, 0, ranges.data());
    return ranges;
  };
  EXPECT_EQ(firstScan(1, 5), firstScan(1, 5));
  EXPECT_NE(firstScan(1, 5), firstScan(2, 5));
  EXPECT_NE(firstScan(1, 5), firstScan(1, 6));
}

TEST(LidarScan, IsExactAfterANoisyOneAsBefore)
{
  CarDescription description = car("robot1");
  description.lidars[0].noise_mean = 0.02;
  description.lidars[0].noise_stddev = 0.01;
  Simulation simulation(world({room(3.0)}));
  simulation.addCar(description, {}, {0.4, 0.3, 0.2});
  std::vector<float> before(1081);
  std::vector<float> noisy(1081);
  std::vector<float> after(1081);
  simulation.exactScan(kRobot1, 0, before.data());
  simulation.scan(kRobot1, 0, noisy.data());
  simulation.exactScan(kRobot1, 0, after.data());
  EXPECT_NE(noisy, before);
  EXPECT_EQ(after, before);
}

TEST(LidarScan, EndsAtTheRangeOfItsOwnLidar)
{
  CarDescription description = carWithSingleBeam("robot1");
  description.lidars.push_back(description.lidars[0]);
  description.lidars[0].range_max = 5.0;
  description.lidars[1].range_max = 2.0;
  Simulation simulation(world({wallAcross(3.0)}));
  simulation.addCar(description, {}, {});
  for (int i = 0; i < 3; ++i) {
    float farther = 0.0F;
    float nearer = 0.0F;
    simulation.exactScan(kRobot1, 0, &farther);
    simulation.exactScan(kRobot1, 1, &nearer);
    EXPECT_FLOAT_EQ(farther, 3.0F - 0.27F);
    EXPECT_EQ(nearer, kNothing);
  }
}

TEST(LidarScan, NoBeamSlipsThroughACorner)
{
  CarDescription description = carWithSingleBeam("robot1", M_PI / 4);
  description.lidars[0].pose = Pose3(0, 0, 0.11, 0, 0, 0);
  for (int i = 0; i < 1000; ++i) {
    const double corner = 1.0 + 0.001 * i;
    const Solid tile = box("tile::l::c", 1, 1, 1, corner + 0.5, corner + 0.5, 0.5);
    Simulation simulation(world({staticModel("tile", tile)}));
    simulation.addCar(description, {}, {});
    ASSERT_NEAR(exactBeam(simulation), corner * std::sqrt(2.0), 1e-5) << corner;
  }
}
}  // namespace f1tenth_sim2d::test
