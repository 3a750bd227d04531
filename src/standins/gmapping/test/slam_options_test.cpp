#include "gmapping/slam_options.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <functional>
#include <string>

#include "gmapping/geometry.h"

namespace gmapping
{
namespace
{
std::string complaint(const std::function<void(SlamOptions &)> & change)
{
  SlamOptions options;
  change(options);
  try {
    options.validate();
  } catch (const OptionError & error) {
    return error.what();
  }
  return "";
}

TEST(SlamOptions, DefaultsAreValid)
{
  EXPECT_EQ(complaint([](SlamOptions &) {}), "");
}

TEST(SlamOptions, WrongValuesAreNamed)
{
  EXPECT_EQ(complaint([](auto & o) { o.delta = -1.0; }), "delta: found -1, must be at least 0.001");
  EXPECT_EQ(complaint([](auto & o) { o.motion.srt = -0.1; }), "srt: found -0.1, must be a number of at least 0");
  EXPECT_EQ(complaint([](auto & o) { o.matcher.iterations = 0; }), "iterations: found 0, must be a number above 0");
  EXPECT_EQ(complaint([](auto & o) { o.max_urange = 0.0; }), "maxUrange: found 0, must be a number above 0");
  EXPECT_EQ(complaint([](auto & o) { o.xmax = -200.0; }), "xmax: found -200, must be above xmin, which is -100");
}

TEST(SlamOptions, MapsThatDoNotFitIntoMemoryAreRefused)
{
  EXPECT_EQ(complaint([](auto & o) { o.delta = 1e-4; }), "delta: found 0.0001, must be at least 0.001");
  EXPECT_EQ(
    complaint([](auto & o) { o.xmax = 1e9; }),
    "xmin, xmax, ymin, ymax, delta: found 8e+13, must be at most 4e+08 cells");
}
}  // namespace
}  // namespace gmapping
