#include "amcl/localizer_options.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <functional>
#include <string>

#include "amcl/geometry.h"

namespace amcl
{
namespace
{
std::string messageOf(const std::function<void()> & action)
{
  try {
    action();
  } catch (const OptionError & error) {
    return error.what();
  }
  return "";
}

std::string complaint(const std::function<void(LocalizerOptions &)> & change)
{
  LocalizerOptions options;
  change(options);
  return messageOf([&] { options.validate(); });
}

TEST(LocalizerOptions, DefaultsAreValid)
{
  EXPECT_EQ(complaint([](LocalizerOptions &) {}), "");
}

TEST(LocalizerOptions, WrongValuesAreNamed)
{
  EXPECT_EQ(complaint([](auto & o) { o.min_particles = -1; }), "min_particles: found -1, must be a number above 0");
  EXPECT_EQ(
    complaint([](auto & o) { o.max_particles = 50; }),
    "max_particles: found 50, must be at least min_particles, which is 100");
  EXPECT_EQ(
    complaint([](auto & o) { o.update_min_d = NAN; }), "update_min_d: found nan, must be a number of at least 0");
  EXPECT_EQ(
    complaint([](auto & o) { o.update_min_a = -0.1; }), "update_min_a: found -0.1, must be a number of at least 0");
  EXPECT_EQ(complaint([](auto & o) { o.kld_err = 0.0; }), "kld_err: found 0, must be a number above 0");
  EXPECT_EQ(complaint([](auto & o) { o.kld_z = INFINITY; }), "kld_z: found inf, must be a number");
  EXPECT_EQ(
    complaint([](auto & o) { o.resample_interval = 0; }), "resample_interval: found 0, must be a number above 0");
  EXPECT_EQ(
    complaint([](auto & o) { o.odometry.alpha3 = -1.0; }), "odom_alpha3: found -1, must be a number of at least 0");
  EXPECT_EQ(complaint([](auto & o) { o.laser.max_beams = 1; }), "laser_max_beams: found 1, must be 2 or above");
  EXPECT_EQ(
    complaint([](auto & o) { o.laser.z_rand = -0.1; }), "laser_z_rand: found -0.1, must be a number of at least 0");
  EXPECT_EQ(
    complaint([](auto & o) { o.laser.sigma_hit = NAN; }), "laser_sigma_hit: found nan, must be a number above 0");
  EXPECT_EQ(complaint([](auto & o) { o.laser.max_range = NAN; }), "laser_max_range: found nan, must be a number");
}
}  // namespace
}  // namespace amcl
