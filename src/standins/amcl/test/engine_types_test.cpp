#include "engine_types.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <limits>
#include <string>

#include "rooms.h"

namespace amcl
{
namespace
{
// Not symmetric about the lidar's axis.
Scan halfScan()
{
  Scan scan{0.0, 0.1, 0.1, 10.0, {}};
  for (int i = 0; i < 11; ++i) {
    scan.ranges.push_back(1.0F + 0.1F * static_cast<float>(i));
  }
  return scan;
}

double beamAngle(const mrpt::obs::CObservation2DRangeScan & observation, std::size_t i)
{
  const double share = static_cast<double>(i) / static_cast<double>(observation.getScanSize() - 1) - 0.5;
  return observation.sensorPose.yaw() + (observation.rightToLeft ? 1.0 : -1.0) * share * observation.aperture;
}

TEST(ToObservation, SpreadsBeamsAndKeepsTheirAngles)
{
  LaserOptions options;
  options.max_beams = 6;
  const auto observation = toObservation(halfScan(), {0.2, 0.0, 0.3}, options);
  ASSERT_EQ(observation->getScanSize(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_FLOAT_EQ(observation->getScanRange(i), 1.0F + 0.2F * static_cast<float>(i));
    EXPECT_NEAR(beamAngle(*observation, i), 0.3 + 0.2 * static_cast<double>(i), 1e-6);
  }
  EXPECT_DOUBLE_EQ(observation->sensorPose.x(), 0.2);
}

TEST(ToObservation, AnglesOfALidarUpsideDownGoTheOtherWay)
{
  Scan scan = halfScan();
  scan.angle_increment = -0.1;
  const auto observation = toObservation(scan, {}, LaserOptions{});
  EXPECT_NEAR(beamAngle(*observation, 0), 0.0, 1e-6);
  EXPECT_NEAR(beamAngle(*observation, 10), -1.0, 1e-6);
}

TEST(ToObservation, HasNeverMoreBeamsThanAskedFor)
{
  LaserOptions options;
  for (options.max_beams = 2; options.max_beams < 20; ++options.max_beams) {
    EXPECT_LE(toObservation(halfScan(), {}, options)->getScanSize(), static_cast<std::size_t>(options.max_beams));
  }
}

TEST(ToObservation, BeamsWithoutAnEchoOrOutOfRangeDoNotCount)
{
  Scan scan = halfScan();
  scan.ranges = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 0.05F, 10.0F, 3.0F};
  const auto observation = toObservation(scan, {}, LaserOptions{});
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(observation->getScanRangeValidity(i), i == 4) << i;
  }
  LaserOptions short_sighted;
  short_sighted.max_range = 2.5;
  EXPECT_FALSE(toObservation(scan, {}, short_sighted)->getScanRangeValidity(4));
}

TEST(ToObservation, ScanWithoutBeamsIsNone)
{
  EXPECT_EQ(toObservation(Scan{}, {}, LaserOptions{}), nullptr);
}

TEST(ToGridMap, HasFreeOccupiedAndUnknownCells)
{
  OccupancyGrid grid = room();
  grid.cells[50 * 160 + 50] = -1;
  const auto map = toGridMap(grid, LaserOptions{});
  ASSERT_EQ(map->getSizeX(), 161U);
  ASSERT_EQ(map->getSizeY(), 101U);
  EXPECT_LT(map->getCell(0, 50), 0.1);
  EXPECT_GT(map->getCell(10, 50), 0.9);
  EXPECT_NEAR(map->getCell(50, 50), 0.5, 0.01);
}

std::string refusal(const OccupancyGrid & grid)
{
  try {
    toGridMap(grid, LaserOptions{});
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

TEST(ToGridMap, MapWithoutCellsIsRefused)
{
  EXPECT_EQ(refusal({{3, 2, 0.05, {}}, {0}}), "the map has 3 x 2 cells of 0.050000 m and data for 1");
}

TEST(ToGridMap, MapWhoseGeometryMakesNoSenseIsRefused)
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

TEST(RandomScope, GivesTheProcessItsOwnGeneratorBack)
{
  auto & shared = mrpt::random::getRandomGenerator();
  shared.randomize(7);
  const double expected = shared.drawUniform(0.0, 1.0);
  shared.randomize(7);
  mrpt::random::CRandomGenerator own(3);
  {
    const RandomScope scope(own);
    EXPECT_EQ(shared.drawUniform(0.0, 1.0), mrpt::random::CRandomGenerator(3).drawUniform(0.0, 1.0));
  }
  EXPECT_EQ(shared.drawUniform(0.0, 1.0), expected);
}
}  // namespace
}  // namespace amcl
