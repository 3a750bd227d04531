#include "likelihood_field.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <cmath>
#include <limits>
#include <string>

#include "rooms.h"

namespace amcl
{
namespace
{
constexpr double kRangeMax = 10.0;

LaserOptions optionsOf(LaserModel model)
{
  LaserOptions options;
  options.model = model;
  return options;
}

/// Log likelihood of one beam ahead from the middle of the room, whose wall is 4.95 m away.
double ofBeam(const LaserOptions & options, double range, const Pose2 & pose = {0.0, -0.5, 0.0})
{
  LikelihoodField field(room(), options);
  field.setRangeMax(kRangeMax);
  return field.logLikelihood({{}, {{{1.0, 0.0}, range}}}, pose);
}

double likelihoodAt(double away)
{
  return 0.95 * std::exp(-0.5 * away * away / 0.04) + 0.05 / kRangeMax;
}

TEST(LikelihoodField, KnowsHowFarABeamEndsFromAWall)
{
  const LaserOptions options = optionsOf(LaserModel::kLikelihoodFieldProb);
  for (const int cells : {0, 1, 5, 20}) {
    const double away = 0.05 * cells;
    EXPECT_NEAR(ofBeam(options, 4.97 - away), std::log(likelihoodAt(away)), 1e-9) << cells;
  }
}

TEST(LikelihoodField, MeasuresAcrossRowsAndColumns)
{
  const LaserOptions options = optionsOf(LaserModel::kLikelihoodFieldProb);
  // The pillar's corner cell is (129, 79); the beam ends three columns and four rows beyond it.
  EXPECT_NEAR(ofBeam(options, 0.0, {3.625, 1.675, 0.0}), std::log(likelihoodAt(0.25)), 1e-9);
}

TEST(LikelihoodField, WallsFartherThanSomeDistanceDoNotCount)
{
  LaserOptions options = optionsOf(LaserModel::kLikelihoodFieldProb);
  options.likelihood_max_dist = 0.4;
  EXPECT_NEAR(ofBeam(options, 2.0), std::log(likelihoodAt(0.4)), 1e-9);
  EXPECT_NEAR(ofBeam(options, 50.0), std::log(likelihoodAt(0.4)), 1e-9);  // outside of the map
}

TEST(LikelihoodField, OfTheOriginalAddsUpCubes)
{
  const double cube = std::pow(likelihoodAt(0.1), 3);
  EXPECT_NEAR(ofBeam(optionsOf(LaserModel::kLikelihoodField), 4.87), std::log(1.0 + cube), 1e-9);
}

TEST(LikelihoodField, BeamModelComparesRanges)
{
  const LaserOptions options = optionsOf(LaserModel::kBeam);
  const double right = ofBeam(options, 4.95);
  EXPECT_NEAR(right, std::log(1.0 + std::pow(likelihoodAt(0.0), 3)), 0.05);
  EXPECT_LT(ofBeam(options, 4.5), right - 0.3);
  EXPECT_LT(ofBeam(options, 5.4), right - 0.3);
}

TEST(LikelihoodField, ScanWithoutEchoesSaysNothing)
{
  LikelihoodField field(room(), optionsOf(LaserModel::kLikelihoodFieldProb));
  field.setRangeMax(kRangeMax);
  EXPECT_EQ(field.logLikelihood({}, {}), 0.0);
}

std::string refusal(const OccupancyGrid & grid)
{
  try {
    LikelihoodField(grid, LaserOptions{});
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

TEST(LikelihoodField, OfAMapWithoutCellsIsRefused)
{
  EXPECT_EQ(refusal({{3, 2, 0.05, {}}, {0}}), "the map has 3 x 2 cells of 0.050000 m and data for 1");
  EXPECT_EQ(refusal({{0, 0, 0.05, {}}, {}}), "the map has 0 x 0 cells of 0.050000 m and data for 0");
}

TEST(LikelihoodField, OfAMapWhoseGeometryMakesNoSenseIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string resolution = "resolution of the map: found ";
  EXPECT_EQ(refusal({{1, 1, 1e-5, {}}, {0}}), resolution + "1e-05, must be a finite number of at least 0.001");
  EXPECT_EQ(refusal({{1, 1, nan, {}}, {0}}), resolution + "nan, must be a finite number of at least 0.001");
  EXPECT_EQ(refusal({{1, 1, 0.001F, {}}, {0}}), "");
  EXPECT_EQ(refusal({{1, 1, 0.05, {nan, 0.0, 0.0}}, {0}}), "x of the map's origin: found nan, must be a finite number");
  EXPECT_EQ(
    refusal({{1, 1, 0.05, {0.0, 0.0, nan}}, {0}}), "yaw of the map's origin: found nan, must be a finite number");
}
}  // namespace
}  // namespace amcl
