#include <gtest/gtest.h>

#include <string>

#include "f1tenth_sim2d/errors.h"
#include "sample_world.h"

// Parameters that programs set are held to the ranges of the YAML files.
namespace f1tenth_sim2d::test
{
namespace
{
std::string refusalOf(const VehicleParameters & parameters)
{
  Simulation simulation(world());
  try {
    simulation.addCar(car("robot1"), parameters, {});
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

std::string refusalWith(double VehicleParameters::*member, double value)
{
  VehicleParameters parameters;
  parameters.*member = value;
  return refusalOf(parameters);
}
}  // namespace

TEST(ParameterRanges, AreThoseOfTheYamlFiles)
{
  using P = VehicleParameters;
  EXPECT_EQ(
    refusalWith(&P::odometry_rate_hz, 0.0),
    "robot1: odometry_rate_hz is 0, allowed are numbers greater than 0, up to 1000 Hz");
  EXPECT_EQ(
    refusalWith(&P::odometry_speed_noise_stddev, kNotANumber),
    "robot1: odometry_speed_noise_stddev is nan, allowed are numbers from 0");
  EXPECT_EQ(
    refusalWith(&P::odometry_steering_offset, 2.0),
    "robot1: odometry_steering_offset is 2, allowed are numbers from -1.5 to 1.5 rad");
  EXPECT_EQ(
    refusalWith(&P::steering_max, 2.0), "robot1: steering_max is 2, allowed are numbers greater than 0, up to 1.5 rad");
  EXPECT_EQ(
    refusalWith(&P::actuation_latency, 1.5), "robot1: actuation_latency is 1.5, allowed are numbers from 0 to 1 s");
  EXPECT_EQ(refusalWith(&P::speed_gain, 1e300), "robot1: speed_gain is 1e+300, allowed is 0 to 1e+09");
  EXPECT_EQ(refusalWith(&P::h, 0.0), "");
}

TEST(ParameterRanges, HoldForTyresToo)
{
  VehicleParameters parameters;
  parameters.tire.r_bx1 = kNotANumber;
  EXPECT_EQ(refusalOf(parameters), "robot1: tire r_bx1 is nan, allowed are numbers");
}

TEST(ParameterRanges, LetTheCentreOfMassBeBeyondAnAxle)
{
  VehicleParameters parameters;
  parameters.l_r = -0.05;
  EXPECT_EQ(refusalOf(parameters), "");
}
}  // namespace f1tenth_sim2d::test
