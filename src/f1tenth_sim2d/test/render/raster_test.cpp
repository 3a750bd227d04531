#include "render/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace f1tenth_sim2d
{
namespace
{
constexpr int kSide = 64;
constexpr float kGreatest = 1e6F;

RasterCorner corner(double x, double y, double depth = 1.0)
{
  return {x * depth, y * depth, depth};
}

Raster drawn(std::vector<std::array<RasterCorner, 3>> triangles, float greatest = kGreatest)
{
  Raster raster;
  raster.clear(kSide, kSide, 0.0F, greatest);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (RasterCorner & each : triangles[i]) {
      raster.locate(each);
    }
    raster.draw(triangles[i][0], triangles[i][1], triangles[i][2], true, static_cast<std::uint32_t>(i));
  }
  return raster;
}

int countOf(const Raster & raster)
{
  int count = 0;
  for (int row = 0; row < kSide; ++row) {
    const std::uint32_t * const ids = raster.triangles(row);
    count += static_cast<int>(std::count_if(ids, ids + kSide, [](auto id) { return id != Raster::kNothing; }));
  }
  return count;
}

TEST(Raster, GivesEachPixelOfAFanToExactlyOneTriangle)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-40, 4 * kSide + 40);
  std::uniform_real_distribution<double> depth(0.2, 9.0);
  for (int round = 0; round < 50; ++round) {
    // In quarters of a pixel, so that many edges run through the middles of pixels.
    const RasterCorner middle =
      corner(kSide / 2 + place(random) / 64.0, kSide / 2 + place(random) / 64.0, depth(random));
    const std::array<RasterCorner, 4> around{
      corner(-99, -99, depth(random)), corner(kSide + 99, -99, depth(random)),
      corner(kSide + 99, kSide + 99, depth(random)), corner(-99, kSide + 99, depth(random))};
    int sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const RasterCorner & a = around[i];
      const RasterCorner & b = around[(i + 1) % 4];
      sum += countOf(drawn({{middle, a, b}}));
    }
    EXPECT_EQ(sum, kSide * kSide) << "round " << round;
  }
}

TEST(Raster, GivesPixelsOnACommonEdgeToOneSide)
{
  for (const double x : {10.0, 10.25, 31.0}) {
    const RasterCorner low = corner(x, -5);
    const RasterCorner high = corner(x, kSide + 5);
    const int left = countOf(drawn({{low, high, corner(-200, 32)}}));
    const int right = countOf(drawn({{low, high, corner(200, 32)}}));
    const int both = countOf(drawn({{low, high, corner(-200, 32)}, {low, high, corner(200, 32)}}));
    EXPECT_EQ(left + right, both);
  }
}

TEST(Raster, ShowsTheNearerOfTwoTriangles)
{
  const auto cover = [](double depth) {
    return std::array{corner(-99, -99, depth), corner(299, -99, depth), corner(-99, 299, depth)};
  };
  for (const auto & [first, second, seen] : {std::tuple{2.0, 3.0, 0U}, std::tuple{3.0, 2.0, 1U}}) {
    const Raster raster = drawn({cover(first), cover(second)});
    EXPECT_EQ(raster.triangles(5)[5], seen);
    EXPECT_FLOAT_EQ(raster.nearness(5)[5], 0.5F);
  }
}

TEST(Raster, CutsATriangleThatReachesBehindTheCamera)
{
  // A floor one unit below the camera, from 3 behind it to 8 ahead of it: pixel row = 32 + 20 / depth.
  const auto onFloor = [](double across, double depth) {
    return RasterCorner{32.0 * depth + 20.0 * across, 32.0 * depth + 20.0, depth};
  };
  const Raster raster =
    drawn({{onFloor(-90, -3), onFloor(-90, 8), onFloor(90, 8)}, {onFloor(-90, -3), onFloor(90, 8), onFloor(90, -3)}});
  for (int row = 0; row < kSide; ++row) {
    const bool is_floor = row >= 32 + 20.0 / 8.0;
    for (const int column : {0, 31, kSide - 1}) {
      EXPECT_EQ(raster.triangles(row)[column] != Raster::kNothing, is_floor) << column << ", " << row;
      if (is_floor) {
        EXPECT_NEAR(raster.nearness(row)[column], (row - 32) / 20.0, 1e-6);
      }
    }
  }
}

TEST(Raster, DrawsNothingNearerThanItsNearLimit)
{
  const std::array<RasterCorner, 3> slope{corner(-99, -99, 0.5), corner(299, -99, 0.5), corner(32, 90, 4.0)};
  const Raster raster = drawn({slope}, 1.0F);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      EXPECT_LE(raster.nearness(row)[column], 1.0F);
    }
  }
  EXPECT_GT(countOf(raster), 0);
}

TEST(Raster, PassesOverWhatHasNoAreaOrIsNotFinite)
{
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  const RasterCorner a = corner(1, 1);
  const RasterCorner b = corner(60, 50);
  EXPECT_EQ(countOf(drawn({{a, a, a}, {a, b, b}, {a, corner(30.5, 25.5), b}})), 0);
  EXPECT_EQ(countOf(drawn({{a, b, corner(kInfinite, 3)}, {a, b, corner(kNotANumber, 3)}, {a, b, {0, 0, 0}}})), 0);
  EXPECT_EQ(countOf(drawn({{corner(1, 1, -1), corner(60, 1, -2), corner(30, 60, -3)}})), 0);
}
}  // namespace
}  // namespace f1tenth_sim2d
