#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "f1tenth_sim2d/section.h"
#include "polygons.h"

namespace f1tenth_sim2d
{
namespace
{
/// A star-shaped outline: simple whatever the radii.
Outline star(std::mt19937 & random, int corners)
{
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    const double r = radius(random);
    outline.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return outline;
}

TEST(ConvexDecomposition, LeavesAConvexOutlineWhole)
{
  const Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto pieces = convexDecomposition(square);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].size(), 4u);
}

TEST(ConvexDecomposition, SplitsACornerInTwo)
{
  const Outline corner{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(convexDecomposition(corner).size(), 2u);
}

TEST(ConvexDecomposition, TakesAClockwiseOutlineAndRedundantCorners)
{
  const Outline outline{{0, 0}, {0, 1}, {0, 1}, {0, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}, {0, 0}};
  const auto pieces = convexDecomposition(outline);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].size(), 4u);
  EXPECT_DOUBLE_EQ(areaOf(pieces), 4.0);
}

TEST(ConvexDecomposition, OfNothingIsNothing)
{
  EXPECT_TRUE(convexDecomposition({}).empty());
  EXPECT_TRUE(convexDecomposition({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(convexDecomposition({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).empty());
}

TEST(ConvexDecomposition, KeepsAreaWithFewConvexPieces)
{
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    const Outline outline = star(random, 3 + round % 60);
    const auto pieces = convexDecomposition(outline);
    EXPECT_TRUE(std::all_of(pieces.begin(), pieces.end(), isConvex));
    EXPECT_NEAR(areaOf(pieces), signedArea(outline), 1e-9);
    EXPECT_LE(pieces.size(), outline.size() - 2);
  }
}

TEST(ConvexDecomposition, OfACombHasOnePieceATooth)
{
  Outline comb;
  for (int tooth = 0; tooth < 20; ++tooth) {
    comb.insert(comb.end(), {{2.0 * tooth, 0.0}, {2.0 * tooth + 1.0, 0.0}, {2.0 * tooth + 1.0, 1.0}});
    comb.push_back({2.0 * tooth + 2.0, 1.0});
  }
  comb.insert(comb.end(), {{40.0, 2.0}, {0.0, 2.0}});
  const auto pieces = convexDecomposition(comb);
  EXPECT_NEAR(areaOf(pieces), 20.0 + 40.0, 1e-9);
  EXPECT_TRUE(std::all_of(pieces.begin(), pieces.end(), isConvex));
  EXPECT_LE(pieces.size(), 41u);
}
}  // namespace
}  // namespace f1tenth_sim2d
