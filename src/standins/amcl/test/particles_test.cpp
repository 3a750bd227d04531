#include "particles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace amcl
{
namespace
{
TEST(DrawAround, HasTheMeanAndTheCovarianceOfTheEstimate)
{
  maths::Random random(1);
  const Estimate wanted{{1.0, 2.0, 0.3}, {0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.01}};
  const Estimate drawn = heaviestCluster(evenly(drawAround(wanted, 50000, random)));
  EXPECT_NEAR(drawn.pose.x, 1.0, 0.005);
  EXPECT_NEAR(drawn.pose.y, 2.0, 0.005);
  EXPECT_NEAR(drawn.pose.yaw, 0.3, 0.005);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(drawn.covariance[i], wanted.covariance[i], 0.002) << i;
  }
}

TEST(DrawAround, WhatIsKnownAlongALineOnlyStaysOnIt)
{
  maths::Random random(1);
  for (const Pose2 & pose : drawAround({{}, {4.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0}}, 100, random)) {
    EXPECT_NEAR(pose.y, 0.5 * pose.x, 1e-12);
    EXPECT_EQ(pose.yaw, 0.0);
  }
}

TEST(Weigh, MultipliesWeightsAndKeepsTheirSum)
{
  Particles particles{{{}, 0.25}, {{}, 0.75}};
  weigh(particles, {std::log(6.0) - 5000.0, std::log(1.0) - 5000.0});  // whose own exponentials are 0
  EXPECT_NEAR(particles[0].weight, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(particles[1].weight, 1.0 / 3.0, 1e-12);
}

TEST(Resampled, DrawsByWeight)
{
  LocalizerOptions options;
  options.min_particles = options.max_particles = 4000;
  maths::Random random(1);
  int firsts = 0;
  for (const WeightedPose & particle : resampled({{{1.0, 0.0, 0.0}, 0.25}, {{2.0, 0.0, 0.0}, 0.75}}, options, random)) {
    EXPECT_EQ(particle.weight, 1.0 / 4000.0);
    firsts += particle.pose.x == 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(firsts, 1000, 100);
}

TEST(Resampled, TakesAsManyAsTheBinsNeed)
{
  const LocalizerOptions options;
  maths::Random random(1);
  Particles certain;
  Particles uncertain;
  for (int i = 0; i < 1000; ++i) {
    certain.push_back({{}, 1e-3});
    uncertain.push_back({{static_cast<double>(i % 10), 0.0, 0.0}, 1e-3});
  }
  EXPECT_EQ(resampled(certain, options, random).size(), 100U);
  // 9 / 0.02 (1 - 2 / 81 + sqrt(2 / 81) 0.99)^3
  EXPECT_EQ(resampled(uncertain, options, random).size(), 651U);
}
}  // namespace
}  // namespace amcl
