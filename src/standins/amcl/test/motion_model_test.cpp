#include "motion_model.h"

#include <gtest/gtest.h>

#include <array>

namespace amcl
{
namespace
{
/// Covariance of x, y and yaw about the motion, of many samples.
std::array<double, 9> covarianceOf(const Pose2 & motion, const OdometryOptions & options)
{
  constexpr int kSamples = 40000;
  maths::Random random(1);
  const MotionModel model(motion, options);
  std::array<double, 9> covariance{};
  for (int i = 0; i < kSamples; ++i) {
    const Pose2 pose = model.sample({}, random);
    const std::array<double, 3> error{pose.x - motion.x, pose.y - motion.y, pose.yaw - motion.yaw};
    for (int k = 0; k < 9; ++k) {
      covariance[k] += error[k / 3] * error[k % 3] / kSamples;
    }
  }
  return covariance;
}

OdometryOptions optionsOf(OdometryModel model)
{
  OdometryOptions options;
  options.model = model;
  options.alpha1 = options.alpha2 = options.alpha3 = options.alpha4 = options.alpha5 = 0.0;
  return options;
}

TEST(MotionModel, StraightWayErrsAlongItAndByTurning)
{
  OdometryOptions options = optionsOf(OdometryModel::kDiffCorrected);
  options.alpha2 = 0.0001;
  options.alpha3 = 0.0004;
  const auto covariance = covarianceOf({2.0, 0.0, 0.0}, options);
  EXPECT_NEAR(covariance[0], 0.0004 * 4.0, 5e-5);
  EXPECT_NEAR(covariance[4], 4.0 * 0.0001 * 4.0, 5e-5);  // the first turn, two metres ahead
  EXPECT_NEAR(covariance[8], 2.0 * 0.0001 * 4.0, 3e-5);  // both turns
  EXPECT_NEAR(covariance[5], 2.0 * 0.0001 * 4.0, 3e-5);
}

TEST(MotionModel, OriginalDiffTakesTheTermsForDeviations)
{
  const auto covariance = covarianceOf({0.1, 0.0, 0.0}, OdometryOptions{});
  EXPECT_NEAR(covariance[0], 0.002 * 0.002, 2e-7);
}

TEST(MotionModel, DrivingBackwardsIsAsSureAsForwards)
{
  OdometryOptions options = optionsOf(OdometryModel::kDiffCorrected);
  options.alpha1 = options.alpha2 = options.alpha3 = 0.0004;
  const auto forwards = covarianceOf({1.0, 0.0, 0.0}, options);
  const auto backwards = covarianceOf({-1.0, 0.0, 0.0}, options);
  EXPECT_NEAR(backwards[0], forwards[0], 2e-5);
  EXPECT_NEAR(backwards[8], forwards[8], 4e-5);
}

TEST(MotionModel, StandingStillIsSure)
{
  maths::Random random(1);
  for (const auto model : {OdometryModel::kDiff, OdometryModel::kOmni, OdometryModel::kOmniCorrected}) {
    OdometryOptions options;
    options.model = model;
    const Pose2 pose = MotionModel({}, options).sample({1.0, 2.0, 0.5}, random);
    EXPECT_EQ(pose.x, 1.0);
    EXPECT_EQ(pose.y, 2.0);
    EXPECT_EQ(pose.yaw, 0.5);
  }
}

TEST(MotionModel, OmniErrsAlongAndAcrossTheWay)
{
  OdometryOptions options = optionsOf(OdometryModel::kOmniCorrected);
  options.alpha3 = 0.04;
  options.alpha5 = 0.01;
  options.alpha2 = 0.02;
  const auto covariance = covarianceOf({0.0, 3.0, 0.0}, options);
  EXPECT_NEAR(covariance[4], 0.04 * 9.0, 0.01);
  EXPECT_NEAR(covariance[0], 0.01 * 9.0, 0.003);
  EXPECT_NEAR(covariance[8], 0.02 * 9.0, 0.006);
}

TEST(MotionModel, MovesInTheFrameOfTheCar)
{
  maths::Random random(1);
  const MotionModel model({1.0, 0.5, 0.2}, optionsOf(OdometryModel::kDiffCorrected));
  const Pose2 pose = model.sample({2.0, 3.0, M_PI / 2.0}, random);
  EXPECT_NEAR(pose.x, 1.5, 1e-12);
  EXPECT_NEAR(pose.y, 4.0, 1e-12);
  EXPECT_NEAR(pose.yaw, M_PI / 2.0 + 0.2, 1e-12);
}
}  // namespace
}  // namespace amcl
