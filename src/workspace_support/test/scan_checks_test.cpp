#include "workspace_support/scan_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace workspace_support
{
namespace
{
std::string complaint(const std::function<void(Scan &)> & change)
{
  Scan scan{-2.0, 0.01, 0.05, 10.0, {1.0F, NAN, INFINITY}};
  change(scan);
  try {
    requireUsable(scan);
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

TEST(RequireUsable, TakesAScanWithoutSomeEchoes)
{
  EXPECT_EQ(complaint([](Scan &) {}), "");
  EXPECT_EQ(complaint([](Scan & scan) { scan.angle_increment = -0.01; }), "");
}

TEST(RequireUsable, NamesTheFieldThatMakesNoSense)
{
  EXPECT_EQ(complaint([](Scan & scan) { scan.angle_min = NAN; }), "angle_min: found nan, must be a finite number");
  EXPECT_EQ(
    complaint([](Scan & scan) { scan.angle_increment = NAN; }),
    "angle_increment: found nan, must be a finite number other than 0");
  EXPECT_EQ(
    complaint([](Scan & scan) { scan.angle_increment = 0.0; }),
    "angle_increment: found 0, must be a finite number other than 0");
  EXPECT_EQ(complaint([](Scan & scan) { scan.range_min = NAN; }), "range_min: found nan, must be a finite number");
  EXPECT_EQ(
    complaint([](Scan & scan) { scan.range_max = INFINITY; }), "range_max: found inf, must be a finite number above 0");
  EXPECT_EQ(
    complaint([](Scan & scan) { scan.range_max = 0.0; }), "range_max: found 0, must be a finite number above 0");
}
}  // namespace
}  // namespace workspace_support
