#include "amcl/estimate.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <cmath>
#include <string>

namespace amcl
{
namespace
{
std::string complaint(const Estimate & estimate)
{
  try {
    estimate.validate();
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

TEST(Estimate, MayBeCertainOrKnownAlongALineOnly)
{
  EXPECT_EQ(complaint({}), "");
  EXPECT_EQ(complaint({{1.0, 2.0, 3.0}, {4.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.1}}), "");
}

TEST(Estimate, HasAFinitePose)
{
  EXPECT_EQ(complaint({{NAN, 0.0, 0.0}, {}}), "x: found nan, must be a finite number");
  EXPECT_EQ(complaint({{0.0, 0.0, INFINITY}, {}}), "yaw: found inf, must be a finite number");
}

TEST(Estimate, HasACovarianceThatThereCanBe)
{
  const std::string name = "least eigenvalue of the covariance: found ";
  EXPECT_EQ(
    complaint({{}, {-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}}), name + "-1, must be a number of at least 0");
  EXPECT_EQ(
    complaint({{}, {1.0, 3.0, 0.0, 3.0, 1.0, 0.0, 0.0, 0.0, 1.0}}), name + "-2, must be a number of at least 0");
  EXPECT_EQ(
    complaint({{}, {NAN, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}}), name + "nan, must be a number of at least 0");
}
}  // namespace
}  // namespace amcl
