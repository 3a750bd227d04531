#include <gtest/gtest.h>

#include <string>

#include "f1tenth_sim2d/errors.h"
#include "sample_world.h"

// Descriptions that programs make, not the loaders, have to make sense, too.
namespace f1tenth_sim2d::test
{
namespace
{
std::string refusalOf(const Pose3 & pose)
{
  Simulation simulation(world());
  ModelDescription crate = movableBox("crate", 0.2, 0.0, 0.0);
  crate.pose = pose;
  try {
    simulation.addModel(crate);
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

std::string refusalOfBias(double mean)
{
  Simulation simulation(world());
  CarDescription biased = car("robot1");
  biased.lidars.at(0).range_max = 10.0;
  biased.lidars.at(0).noise_mean = mean;
  try {
    simulation.addCar(biased, {}, {});
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(DescriptionRanges, OfPosesOfModelsAreFiniteAndNear)
{
  EXPECT_EQ(
    refusalOf(Pose3(0, 0, 0, 0, 0, kNotANumber)),
    "test.world: model crate: rotation is nan, allowed is a finite number");
  EXPECT_EQ(
    refusalOf(Pose3(0, -1e30, 0, 0, 0, 0)), "test.world: model crate: y (m) is -1e+30, allowed is -100000 to 100000");
  EXPECT_EQ(
    refusalOf(Pose3(0, 0, kNotANumber, 0, 0, 0)),
    "test.world: model crate: z (m) is nan, allowed is -100000 to 100000");
}

TEST(DescriptionRanges, OfTheBiasOfALidarAreWithinItsRange)
{
  EXPECT_EQ(refusalOfBias(10.0), "");
  EXPECT_NE(refusalOfBias(-10.5).find(": bias (m) is -10.5, allowed is -10 to 10"), std::string::npos);
  EXPECT_NE(refusalOfBias(kNotANumber).find(": bias (m) is nan, allowed is -10 to 10"), std::string::npos);
}
}  // namespace f1tenth_sim2d::test
