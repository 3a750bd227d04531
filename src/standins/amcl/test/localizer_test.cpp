#include "amcl/localizer.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "rooms.h"

namespace amcl
{
namespace
{
const Pose2 kLidar{0.2, 0.0, 0.0};

LocalizerOptions smallSteps()
{
  LocalizerOptions options;
  options.update_min_d = 0.05;
  options.update_min_a = 0.05;
  options.resample_interval = 1;
  options.laser.max_beams = 60;
  options.laser.sigma_hit = 0.1;
  options.odometry.model = OdometryModel::kDiffCorrected;  // The other one hardly errs in such small steps.
  options.odometry.alpha1 = options.odometry.alpha2 = options.odometry.alpha3 = options.odometry.alpha4 = 0.02;
  return options;
}

Estimate around(const Pose2 & pose, double deviation, double yaw_deviation)
{
  const double variance = deviation * deviation;
  return {pose, {variance, 0.0, 0.0, 0.0, variance, 0.0, 0.0, 0.0, yaw_deviation * yaw_deviation}};
}

// A way through the map; odometry starts at its own origin and turns away by 2 degrees per metre.
class Drive
{
public:
  Drive(const OccupancyGrid & map, const Pose2 & start) : map_(map), truth_(start) {}

  Outcome step(Localizer & localizer, const Pose2 & motion = {0.06, 0.0, 0.0})
  {
    truth_ = compose(truth_, motion);
    odometry_ = compose(odometry_, {motion.x, motion.y, motion.yaw + 0.035 * motion.x});
    return localizer.process(scanOn(map_, compose(truth_, kLidar)), kLidar, odometry_);
  }
  void steps(Localizer & localizer, int count, const Pose2 & motion = {0.06, 0.0, 0.0})
  {
    for (int i = 0; i < count; ++i) {
      step(localizer, motion);
    }
  }
  const Pose2 & truth() const { return truth_; }

private:
  OccupancyGrid map_;
  Pose2 truth_;
  Pose2 odometry_;
};

void expectNear(const Pose2 & found, const Pose2 & wanted, double distance, double angle)
{
  EXPECT_NEAR(found.x, wanted.x, distance);
  EXPECT_NEAR(found.y, wanted.y, distance);
  EXPECT_NEAR(normalizeAngle(found.yaw - wanted.yaw), 0.0, angle);
}

TEST(Localizer, StartsWhereItIsTold)
{
  const auto localizer = Localizer::make(room(), smallSteps(), around({1.0, 0.5, 0.3}, 0.1, 0.05));
  expectNear(localizer->estimate().pose, {1.0, 0.5, 0.3}, 0.01, 0.005);
  EXPECT_NEAR(localizer->estimate().covariance[0], 0.01, 0.001);
  EXPECT_NEAR(localizer->estimate().covariance[8], 0.0025, 0.0003);
  EXPECT_EQ(localizer->particles().size(), 5000U);
}

TEST(Localizer, FindsTheCarFromAnOffset)
{
  for (const auto model : {LaserModel::kLikelihoodField, LaserModel::kLikelihoodFieldProb, LaserModel::kBeam}) {
    LocalizerOptions options = smallSteps();
    options.laser.model = model;
    const auto localizer = Localizer::make(room(), options, around({-1.7, -0.8, 0.15}, 0.4, 0.2));
    Drive drive(room(), {-2.0, -0.5, 0.0});
    drive.steps(*localizer, 40);
    SCOPED_TRACE(static_cast<int>(model));
    expectNear(localizer->estimate().pose, drive.truth(), 0.05, 0.02);
  }
}

TEST(Localizer, FindsTheCarWithoutRandomBeamsToo)
{
  LocalizerOptions options = smallSteps();
  options.laser.model = LaserModel::kLikelihoodFieldProb;
  options.laser.z_rand = 0.0;
  options.laser.sigma_hit = 0.02;  // ends of beams some way off a wall have no likelihood at all
  const auto localizer = Localizer::make(room(), options, around({-1.9, -0.6, 0.05}, 0.2, 0.1));
  Drive drive(room(), {-2.0, -0.5, 0.0});
  drive.steps(*localizer, 40);
  expectNear(localizer->estimate().pose, drive.truth(), 0.06, 0.03);
}

TEST(Localizer, MapsMayLieAskew)
{
  const Pose2 origin{4.013, -1.027, 0.7};
  const OccupancyGrid map = room(origin);
  const Pose2 start = compose(origin, {1.0, 2.0, 0.0});
  const auto localizer = Localizer::make(map, smallSteps(), around(compose(start, {0.2, 0.1, 0.1}), 0.3, 0.15));
  Drive drive(map, start);
  drive.steps(*localizer, 40);
  expectNear(localizer->estimate().pose, drive.truth(), 0.04, 0.02);
}

TEST(Localizer, IsNoSurerThanItsMap)
{
  const auto localizer = Localizer::make(room(), smallSteps(), around({-2.0, -0.5, 0.0}, 0.05, 0.05));
  Drive drive(room(), {-2.0, -0.5, 0.0});
  drive.steps(*localizer, 40);
  const Estimate estimate = localizer->estimate();
  EXPECT_GT(std::min(estimate.covariance[0], estimate.covariance[4]), 0.025 * 0.025);  // half a cell
  EXPECT_LT(std::max(estimate.covariance[0], estimate.covariance[4]), 0.05 * 0.05);
}

TEST(Localizer, SpreadsOverFreeCellsOnly)
{
  const auto localizer = Localizer::make(room(), smallSteps(), {});
  localizer->spreadOut();
  EXPECT_EQ(localizer->particles().size(), 5000U);
  for (const Pose2 & particle : localizer->particles()) {
    const bool in_room = particle.x > -3.0 && particle.x < 5.0 && particle.y > -2.5 && particle.y < 2.5;
    const bool in_pillar = particle.x > 3.06 && particle.x < 3.44 && particle.y > 0.56 && particle.y < 1.44;
    EXPECT_TRUE(in_room && !in_pillar) << particle.x << " " << particle.y;
  }
}

TEST(Localizer, NeedsFewerParticlesTheSurerItIs)
{
  const auto localizer = Localizer::make(room(), smallSteps(), around({-2.0, -0.5, 0.0}, 0.4, 0.2));
  Drive drive(room(), {-2.0, -0.5, 0.0});
  EXPECT_EQ(localizer->particles().size(), 5000U);
  drive.steps(*localizer, 20);
  EXPECT_LT(localizer->particles().size(), 1000U);
  EXPECT_GE(localizer->particles().size(), 100U);
}

TEST(Localizer, SameSeedGivesTheSameParticlesAndAnotherSeedOthers)
{
  LocalizerOptions options = smallSteps();
  const Estimate start = around({-2.0, -0.5, 0.0}, 0.2, 0.1);
  const auto first = Localizer::make(room(), options, start);
  const auto second = Localizer::make(room(), options, start);
  options.seed = 1;
  const auto other = Localizer::make(room(), options, start);
  Drive one(room(), start.pose);
  Drive two(room(), start.pose);
  Drive three(room(), start.pose);
  for (int i = 0; i < 10; ++i) {  // Taking turns: they must not draw from each other's random numbers.
    one.step(*first);
    two.step(*second);
    three.step(*other);
  }
  ASSERT_EQ(first->particles().size(), second->particles().size());
  EXPECT_EQ(first->particles().back().x, second->particles().back().x);
  EXPECT_EQ(first->estimate().pose.yaw, second->estimate().pose.yaw);
  EXPECT_NE(first->estimate().pose.yaw, other->estimate().pose.yaw);
}

TEST(Localizer, OnlyScansFarEnoughFromTheLastCount)
{
  LocalizerOptions options = smallSteps();
  options.resample_interval = 2;
  const auto localizer = Localizer::make(room(), options, around({-2.0, -0.5, 0.0}, 0.05, 0.05));
  Drive drive(room(), {-2.0, -0.5, 0.0});
  EXPECT_EQ(drive.step(*localizer, {}), Outcome::kUpdated);
  EXPECT_EQ(drive.step(*localizer, {0.04, 0.0, 0.0}), Outcome::kIgnored);
  EXPECT_EQ(drive.step(*localizer, {0.02, 0.0, 0.0}), Outcome::kResampled);
  EXPECT_EQ(drive.step(*localizer, {0.0, 0.0, 0.06}), Outcome::kUpdated);
  EXPECT_EQ(drive.step(*localizer, {}), Outcome::kIgnored);
  localizer->updateNext();
  EXPECT_EQ(drive.step(*localizer, {}), Outcome::kResampled);
}

TEST(Localizer, BelievesWhatItIsToldLater)
{
  const auto localizer = Localizer::make(room(), smallSteps(), around({-2.0, -0.5, 0.0}, 0.05, 0.05));
  localizer->setPose(around({2.0, 1.0, -1.0}, 0.05, 0.05));
  expectNear(localizer->estimate().pose, {2.0, 1.0, -1.0}, 0.01, 0.01);
}

TEST(Localizer, MapOnWhichNothingIsFreeIsNamed)
{
  OccupancyGrid map = room();
  map.cells.assign(map.cells.size(), 100);
  const auto localizer = Localizer::make(map, smallSteps(), {});
  try {
    localizer->spreadOut();
    FAIL();
  } catch (const Error & error) {
    EXPECT_STREQ(error.what(), "nothing is free on the map");
  }
}
}  // namespace
}  // namespace amcl
