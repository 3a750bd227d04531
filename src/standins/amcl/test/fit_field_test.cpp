#include "fit_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "amcl/localizer_options.h"
#include "engine_types.h"

namespace amcl
{
namespace
{
constexpr std::int8_t kWallCell = 100;

/// A map of 2 m by 2 m with one of these values in each column of cells of 0.1 m.
mrpt::maps::COccupancyGridMap2D::Ptr mapOf(const std::vector<std::int8_t> & columns)
{
  OccupancyGrid grid{{20, 20, 0.1, {}}, {}};
  for (int i = 0; i < 20 * 20; ++i) {
    grid.cells.push_back(columns[i % 20]);
  }
  return toGridMap(grid, LaserOptions{});
}

/// Free up to 1 m, then this, then walls.
std::vector<std::int8_t> beforeWalls(const std::vector<std::int8_t> & between)
{
  std::vector<std::int8_t> columns(20, kWallCell);
  std::fill_n(columns.begin(), 10, 0);
  std::copy(between.begin(), between.end(), columns.begin() + 10);
  return columns;
}

double closeFitAt(const FitField & field, double x)
{
  return field.close(Fit(0.0, 0.1), {{x, 1.0}}, {});
}

TEST(FitField, FitsBestWhereTheWallBegins)
{
  const FitField field(*mapOf(beforeWalls({})));
  EXPECT_NEAR(closeFitAt(field, 1.0), 1.0, 0.01);
  for (const double away : {0.02, 0.05, 0.1, 0.15}) {
    const double expected = std::exp(-0.5 * away * away / 0.01);
    EXPECT_NEAR(closeFitAt(field, 1.0 - away), expected, 0.03) << away;
    EXPECT_NEAR(closeFitAt(field, 1.0 + away), expected, 0.03) << away;
  }
}

TEST(FitField, KnowsOnlyTheCellRoughly)
{
  const FitField field(*mapOf(beforeWalls({})));
  const Fit fit(0.0, 0.1);
  EXPECT_DOUBLE_EQ(field.rough(fit, {{0.91, 1.0}}, {}), field.rough(fit, {{0.99, 1.0}}, {}));
  EXPECT_NEAR(field.rough(fit, {{0.95, 1.0}}, {}), std::exp(-0.125), 0.03);
}

TEST(FitField, BeginsAWallBehindCellsThatAreNotKnownBesideFreeOnes)
{
  const FitField field(*mapOf(beforeWalls({-1})));
  EXPECT_NEAR(closeFitAt(field, 1.1), 1.0, 0.01);
  EXPECT_NEAR(closeFitAt(field, 1.0), std::exp(-0.5), 0.03);
}

TEST(FitField, HasNoWallWhereNothingIsKnownBehindWhatIsFree)
{
  std::vector<std::int8_t> columns(10, 0);
  columns.resize(20, -1);
  const FitField field(*mapOf(columns));
  EXPECT_EQ(closeFitAt(field, 1.0), 0.0);
  EXPECT_EQ(closeFitAt(field, 1.1), 0.0);
}

TEST(FitField, CountsNothingFarInsideOfAWallAndOutsideOfTheMap)
{
  const FitField field(*mapOf(beforeWalls({})));
  EXPECT_EQ(closeFitAt(field, 1.8), 0.0);
  for (const Vec2 & outside : {Vec2{-0.1, 1.0}, Vec2{3.0, 1.0}, Vec2{1.0, -0.1}, Vec2{1.0, 3.0}}) {
    EXPECT_EQ(field.close(Fit(0.0, 0.1), {outside}, {}), 0.0);
    EXPECT_EQ(field.rough(Fit(0.0, 0.1), {outside}, {}), 0.0);
  }
}

TEST(FitField, TakesThePointsFromTheFrameOfThePose)
{
  const FitField field(*mapOf(beforeWalls({})));
  EXPECT_NEAR(field.close(Fit(0.0, 0.1), {{0.0, -0.4}}, {0.6, 1.0, M_PI_2}), 1.0, 0.01);
}

TEST(FitField, GivesUpWhatIsCertainlyWorseThanTheLeast)
{
  const FitField field(*mapOf(beforeWalls({})));
  const Points half{{1.0, 1.0}, {0.3, 1.0}};
  EXPECT_NEAR(field.close(Fit(0.0, 0.1), half, {}), 0.5, 0.01);
  EXPECT_EQ(field.close(Fit(0.0, 0.1), half, {}, 0.6), 0.0);
}

TEST(Fit, IsFullWithinTheSlack)
{
  const FitField field(*mapOf(beforeWalls({})));
  EXPECT_DOUBLE_EQ(field.close(Fit(0.1, 0.1), {{0.92, 1.0}}, {}), 1.0);
  EXPECT_NEAR(field.close(Fit(0.1, 0.1), {{0.8, 1.0}}, {}), std::exp(-0.5), 0.03);
}
}  // namespace
}  // namespace amcl
