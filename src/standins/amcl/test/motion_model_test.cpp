#include "motion_model.h"

#include <gtest/gtest.h>

namespace amcl
{
namespace
{
TEST(MotionCovariance, StraightWayErrsAlongItAndByTurning)
{
  OdometryOptions options;
  options.model = OdometryModel::kDiffCorrected;
  options.alpha2 = 0.01;
  options.alpha3 = 0.04;
  const auto covariance = motionCovariance({2.0, 0.0, 0.0}, options);
  EXPECT_NEAR(covariance(0, 0), 0.04 * 4.0, 1e-12);
  EXPECT_NEAR(covariance(1, 1), 4.0 * 0.01 * 4.0, 1e-12);  // the first turn, two metres ahead
  EXPECT_NEAR(covariance(2, 2), 2.0 * 0.01 * 4.0, 1e-12);  // both turns
  EXPECT_NEAR(covariance(1, 2), 2.0 * 0.01 * 4.0, 1e-12);
}

TEST(MotionCovariance, OriginalDiffTakesTheTermsForDeviations)
{
  OdometryOptions options;
  const auto covariance = motionCovariance({0.1, 0.0, 0.0}, options);
  EXPECT_NEAR(covariance(0, 0), 0.002 * 0.002, 1e-15);
}

TEST(MotionCovariance, DrivingBackwardsIsAsSureAsForwards)
{
  OdometryOptions options;
  options.model = OdometryModel::kDiffCorrected;
  const auto forwards = motionCovariance({1.0, 0.0, 0.0}, options);
  const auto backwards = motionCovariance({-1.0, 0.0, 0.0}, options);
  EXPECT_NEAR(backwards(0, 0), forwards(0, 0), 1e-12);
  EXPECT_NEAR(backwards(2, 2), forwards(2, 2), 1e-12);
}

TEST(MotionCovariance, StandingStillIsSure)
{
  for (const auto model : {OdometryModel::kDiff, OdometryModel::kOmni, OdometryModel::kOmniCorrected}) {
    OdometryOptions options;
    options.model = model;
    EXPECT_EQ(motionCovariance({}, options).cwiseAbs().maxCoeff(), 0.0);
  }
}

TEST(MotionCovariance, OmniErrsAlongAndAcrossTheWay)
{
  OdometryOptions options;
  options.model = OdometryModel::kOmniCorrected;
  options.alpha3 = 0.04;
  options.alpha5 = 0.01;
  options.alpha2 = 0.02;
  const auto covariance = motionCovariance({0.0, 3.0, 0.0}, options);
  EXPECT_NEAR(covariance(1, 1), 0.04 * 9.0, 1e-12);
  EXPECT_NEAR(covariance(0, 0), 0.01 * 9.0, 1e-12);
  EXPECT_NEAR(covariance(2, 2), 0.02 * 9.0, 1e-12);
}
}  // namespace
}  // namespace amcl
