#include "clusters.h"

#include <gtest/gtest.h>

namespace amcl
{
namespace
{
TEST(HeaviestCluster, LeavesOutTheLighterGroup)
{
  const Estimate estimate =
    heaviestCluster({{{1.0, 1.0, 0.0}, 0.3}, {{1.2, 1.2, 0.1}, 0.3}, {{9.0, 9.0, 0.0}, 0.25}, {{9.0, 9.1, 0.0}, 0.15}});
  EXPECT_NEAR(estimate.pose.x, 1.1, 1e-12);
  EXPECT_NEAR(estimate.pose.y, 1.1, 1e-12);
  EXPECT_NEAR(estimate.pose.yaw, 0.05, 1e-12);
  EXPECT_NEAR(estimate.covariance[0], 0.01, 1e-12);
  EXPECT_NEAR(estimate.covariance[1], 0.01, 1e-12);
  EXPECT_NEAR(estimate.covariance[8], 0.0025, 1e-12);
}

TEST(HeaviestCluster, WeightsCountNotNumbers)
{
  const Estimate estimate =
    heaviestCluster({{{1.0, 0.0, 0.0}, 0.1}, {{1.0, 0.0, 0.0}, 0.1}, {{1.0, 0.0, 0.0}, 0.1}, {{5.0, 0.0, 0.0}, 0.7}});
  EXPECT_DOUBLE_EQ(estimate.pose.x, 5.0);
}

TEST(HeaviestCluster, HeadingsAreJoinedAcrossHalfATurn)
{
  const Estimate estimate = heaviestCluster({{{0.0, 0.0, 3.1}, 0.5}, {{0.0, 0.0, -3.1}, 0.5}});
  EXPECT_NEAR(std::abs(estimate.pose.yaw), M_PI, 1e-12);
  EXPECT_NEAR(estimate.covariance[8], (M_PI - 3.1) * (M_PI - 3.1), 1e-12);
}

TEST(HeaviestCluster, OppositeHeadingsAtOnePlaceAreTwoGroups)
{
  const Estimate estimate = heaviestCluster({{{0.0, 0.0, 0.0}, 0.4}, {{0.0, 0.0, 3.0}, 0.6}});
  EXPECT_DOUBLE_EQ(estimate.pose.yaw, 3.0);
}
}  // namespace
}  // namespace amcl
