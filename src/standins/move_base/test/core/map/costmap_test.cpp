#include "move_base/map/costmap.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <limits>
#include <random>

#include "expect_throws.h"
#include "rooms.h"

namespace move_base
{
namespace
{
using testing::drawMap;
using testing::drawRoom;
using testing::inRectangle;
using testing::makeCostmap;
using testing::scanFrom;

constexpr double kCell = 0.05;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Footprint, discsCoverTheOutline)
{
  const Footprint footprint(defaultFootprint());
  for (double x = -0.125; x <= 0.455; x += 0.01) {
    for (const double y : {-0.155, 0.0, 0.155}) {
      double least = kInfinite;
      for (const Disc & disc : footprint.discs()) {
        least = std::min(least, distance(disc.centre, Vec2{x, y}) - disc.radius);
      }
      EXPECT_LE(least, 1e-9) << x << ", " << y;
    }
  }
}

TEST(Footprint, discsStickOutLittle)
{
  const Footprint footprint(defaultFootprint());
  for (const Disc & disc : footprint.discs()) {
    EXPECT_LE(disc.centre.x + disc.radius, 0.455 + 0.04);
    EXPECT_GE(disc.centre.x - disc.radius, -0.125 - 0.04);
    EXPECT_LE(std::abs(disc.centre.y) + disc.radius, 0.155 + 0.02);
  }
}

TEST(Footprint, paddingGrowsEverySide)
{
  EXPECT_NEAR(Footprint(defaultFootprint(), 0.02).corners()[0].x, 0.475, 1e-12);
  EXPECT_NEAR(Footprint(defaultFootprint(), 0.02).corners()[2].y, -0.175, 1e-12);
}

TEST(Footprint, inscribedRadiusIsToTheNearestEdge)
{
  EXPECT_NEAR(Footprint(defaultFootprint()).inscribedRadius(), 0.125, 1e-12);
  EXPECT_NEAR(Footprint(defaultFootprint(), 0.01).inscribedRadius(), 0.135, 1e-12);
}

TEST(Footprint, refusesAnOutlineWithoutAnArea)
{
  const std::string text = "footprint: needs at least three corners that enclose an area";
  EXPECT_THROWS_MESSAGE(Footprint({{0.0, 0.0}, {1.0, 0.0}}), OptionError, text);
  EXPECT_THROWS_MESSAGE(Footprint({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}), OptionError, text);
}

TEST(Costmap, tellsTheDistanceToAWall)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  EXPECT_NEAR(costmap.obstacleDistance({3.0, 1.1}), 1.0, 0.01);
  EXPECT_LE(costmap.obstacleDistance({3.0, 0.05}), 0.0);
  EXPECT_LE(costmap.obstacleDistance({-1.0, 2.0}), 0.0);
}

TEST(Costmap, clearanceOfTheCarIsThatOfItsOutline)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  EXPECT_NEAR(costmap.clearance({3.0, 1.0, 0.0}), 1.0 - 0.1 - 0.155, 0.021);
  EXPECT_NEAR(costmap.clearance({3.0, 1.0, -M_PI / 2.0}), 1.0 - 0.1 - 0.455, 0.04);
  EXPECT_LT(costmap.clearance({3.0, 0.2, 0.0}), 0.0);
}

// Calls isFarFromAll at seeded random places, and holds it against clearances there and beside. Counts how often it is true.
int countFarPlaces(const Costmap & costmap, double width, double height)
{
  constexpr double kMargin = 0.1;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int far = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pose2 pose{part(generator) * width, part(generator) * height, 2.0 * M_PI * part(generator)};
    if (costmap.isFarFromAll(pose, kMargin)) {
      ++far;
      const Pose2 beside = advance({pose.x, pose.y, 2.0 * M_PI * part(generator)}, kMargin, 0.0);
      EXPECT_EQ(costmap.proximityCost(costmap.clearance(pose) - kMargin), 0.0) << pose.x << ", " << pose.y;
      EXPECT_EQ(costmap.proximityCost(costmap.clearance({beside.x, beside.y, pose.yaw})), 0.0);
    }
  }
  return far;
}

TEST(Costmap, whereItIsFarFromAllNothingAddsToTheCost)
{
  const OccupancyGrid map = drawMap(12.0, 9.0, [](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {11.9, 8.9}) || distance(p, {3.0, 3.0}) < 0.05 ||
           std::abs(p.x - p.y - 5.0) < 0.04;
  });
  EXPECT_GT(countFarPlaces(makeCostmap(map), 12.0, 9.0), 2000);
}

TEST(Costmap, farFromAllHeedsWhatTheLidarSaw)
{
  Costmap costmap = makeCostmap(drawRoom(12.0, 9.0));
  const int before = countFarPlaces(costmap, 12.0, 9.0);
  costmap.observe(scanFrom({3.0, 4.5, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 2.0 : 20.0; }));
  const int after = countFarPlaces(costmap, 12.0, 9.0);
  EXPECT_GT(after, 500);
  EXPECT_LT(after, before);
}

// Lidars that look all around may begin at their left as well as behind.
TEST(Costmap, forgetsWhatAScanOfPositiveAnglesSeesThrough)
{
  for (const double direction : {-1.5, 1.5}) {
    Costmap costmap = makeCostmap(drawRoom(12.0, 9.0));
    const Pose2 there{6.0 + 2.0 * std::cos(direction), 4.5 + 2.0 * std::sin(direction), 0.0};
    for (const double time : {0.0, 1.0}) {
      LaserScan scan = scanFrom({6.0, 4.5, M_PI}, [&](double angle) {
        return time == 0.0 && std::abs(normalizeAngle(angle - direction)) < 0.1 ? 2.0 : 8.0;
      });
      scan.sensor.yaw = 0.0;
      scan.angle_min = 0.0;
      scan.time = time;
      costmap.observe(scan);
      EXPECT_EQ(costmap.clearance(there) < 0.0, time == 0.0) << direction;
    }
  }
}

TEST(Costmap, nothingIsFarFromTheEdgeOfTheMap)
{
  const Costmap costmap = makeCostmap(drawMap(12.0, 9.0, [](const Vec2 &) { return false; }));
  EXPECT_TRUE(costmap.isFarFromAll({6.0, 4.5, 0.0}, 0.1));
  EXPECT_FALSE(costmap.isFarFromAll({0.3, 4.5, M_PI}, 0.1));
  EXPECT_FALSE(costmap.isFarFromAll({13.0, 4.5, 0.0}, 0.1));
}

TEST(Costmap, unknownPatchesNarrowerThanACarDoNotCloseTheRoad)
{
  OccupancyGrid map = drawRoom(6.0, 2.0);
  const auto forget = [&](const Vec2 & low, const Vec2 & high) {
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      const bool inside = inRectangle(map.geometry.centre(map.geometry.cell(i)), low, high);
      map.cells[i] = inside && map.cells[i] == 0 ? -1 : map.cells[i];
    }
  };
  forget({1.5, 0.9}, {1.6, 1.0});  // a speck
  forget({3.0, 0.0}, {3.2, 2.0});  // a sliver across the road
  EXPECT_GT(makeCostmap(map).clearance({1.4, 1.0, 0.0}), 0.5);
  EXPECT_GT(makeCostmap(map).clearance({3.0, 1.0, 0.0}), 0.5);
  forget({4.5, 0.5}, {5.0, 1.5});
  EXPECT_LT(makeCostmap(map).clearance({4.5, 1.0, 0.0}), 0.0) << "wider than a car";
}

TEST(Costmap, unknownIsAnObstacleUnlessAllowed)
{
  OccupancyGrid map = drawRoom(6.0, 4.0);
  for (int y = 0; y < map.geometry.height; ++y) {
    for (int x = 56; x < 66; ++x) {
      map.cells[map.geometry.index({x, y})] = -1;
    }
  }
  EXPECT_LE(makeCostmap(map).obstacleDistance({3.02, 2.0}), 0.0);
  CostmapOptions options;
  options.allow_unknown = true;
  EXPECT_GT(makeCostmap(map, options).obstacleDistance({3.02, 2.0}), 1.0);
}

TEST(Costmap, costFallsWithClearanceToNothingAtTheInflationRadius)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  EXPECT_DOUBLE_EQ(costmap.proximityCost(-0.1), Costmap::kTouchingPrice);
  EXPECT_GT(costmap.proximityCost(0.1), costmap.proximityCost(0.3));
  EXPECT_EQ(costmap.proximityCost(0.8), 0.0);
}

TEST(Costmap, marksWhatTheMapDoesNotKnow)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  const auto wall = [](double angle) { return std::abs(normalizeAngle(angle)) < 0.1 ? 2.0 : kInfinite; };
  costmap.observe(scanFrom({2.0, 2.0, 0.3}, wall));
  EXPECT_NEAR(costmap.obstacleDistance({4.0, 2.0}), 0.0, kCell);
  EXPECT_NEAR(costmap.obstacleDistance({3.6, 2.0}), 0.4, 1.01 * kCell);
  EXPECT_FALSE(costmap.liveCells().empty());
}

TEST(Costmap, doesNotChangeWithAScanThatSaysTheSame)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  const LaserScan scan =
    scanFrom({2.0, 2.0, 0.3}, [](double angle) { return std::abs(normalizeAngle(angle)) < 0.1 ? 2.0 : kInfinite; });
  const auto seen = [&costmap] {
    std::vector<double> distances;
    for (std::size_t i = 0; i < costmap.geometry().size(); ++i) {
      distances.push_back(costmap.obstacleDistance(costmap.geometry().centre(costmap.geometry().cell(i))));
    }
    return distances;
  };
  costmap.observe(scan);
  const std::size_t marked = costmap.liveCells().size();
  const std::vector<double> before = seen();
  costmap.observe(scan);
  EXPECT_GT(marked, 0U);
  EXPECT_EQ(costmap.liveCells().size(), marked);
  EXPECT_EQ(seen(), before);
}

TEST(Costmap, doesNotMarkTheWallsOfTheMap)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return 1.95 / std::abs(std::sin(angle)); }));
  EXPECT_TRUE(costmap.liveCells().empty());
}

TEST(Costmap, takesAHitBesideACellOfAWallForTheWall)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return 1.82 / std::abs(std::sin(angle)); }));
  EXPECT_TRUE(costmap.liveCells().empty());
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return 1.77 / std::abs(std::sin(angle)); }));
  EXPECT_FALSE(costmap.liveCells().empty());
}

TEST(Costmap, clearsWhatTheLidarSeesThrough)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  const double before = costmap.obstacleDistance({4.0, 2.0});
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 2.0 : kInfinite; }));
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 1.0 : kInfinite; }));
  EXPECT_LT(costmap.obstacleDistance({4.0, 2.0}), kCell) << "hidden is not gone";
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double) { return kInfinite; }));
  EXPECT_DOUBLE_EQ(costmap.obstacleDistance({4.0, 2.0}), before);
}

TEST(Costmap, ignoresHitsBeyondTheObstacleRange)
{
  CostmapOptions options;
  options.live.obstacle_range = 1.5;
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0), options);
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 2.0 : kInfinite; }));
  EXPECT_TRUE(costmap.liveCells().empty());
}

TEST(Costmap, forgetsWhatIsFartherThanTheRadius)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  costmap.observe(scanFrom({4.0, 2.0, 0.0}, [](double angle) {
    return std::abs(angle) < 0.1 ? 1.0 : std::abs(angle) > 3.0 ? 3.0 : kInfinite;
  }));
  costmap.forgetBeyond({4.0, 2.0}, 2.0);
  EXPECT_LT(costmap.obstacleDistance({5.0, 2.0}), kCell);
  EXPECT_GT(costmap.obstacleDistance({1.0, 2.0}), 0.5);
}

TEST(Costmap, showsTheCostsOfTheOriginal)
{
  OccupancyGrid map = drawRoom(6.0, 4.0);
  map.cells[map.geometry.index({60, 40})] = 100;
  const Footprint footprint(defaultFootprint());
  ASSERT_NEAR(footprint.inscribedRadius(), 0.125, 1e-12);
  const Costmap costmap(map, CostmapOptions{}, footprint);
  const auto at = [&](int x, int y) { return static_cast<int>(costmap.shownCost(costmap.geometry().index({x, y}))); };
  EXPECT_EQ(at(60, 40), 100);
  EXPECT_EQ(at(58, 40), 99) << "0.1 m: the car surely touches it";
  // costmap_2d: 252 exp(-10 (d - 0.125)) cut to a whole number, 1 to 252 shown as 1 to 98.
  EXPECT_EQ(at(57, 40), 1 + 97 * (196 - 1) / 251) << "0.15 m";
  EXPECT_EQ(at(56, 40), 1 + 97 * (119 - 1) / 251) << "0.2 m";
  EXPECT_EQ(at(48, 40), 0) << "0.6 m";
}

TEST(Costmap, showsUnknownCellsUnlessTheCarTouchesSomethingThere)
{
  OccupancyGrid map = drawRoom(6.0, 4.0);
  map.cells[map.geometry.index({60, 40})] = map.cells[map.geometry.index({60, 2})] = -1;
  const Costmap costmap = makeCostmap(map);
  EXPECT_EQ(costmap.shownCost(map.geometry.index({60, 40})), -1);
  EXPECT_EQ(costmap.shownCost(map.geometry.index({60, 2})), 99);
}

TEST(Costmap, showsWhatTheLidarSees)
{
  Costmap costmap = makeCostmap(drawRoom(10.0, 4.0));
  const std::size_t there = costmap.geometry().index(costmap.geometry().cellAt({4.0, 2.0}));
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 2.01 : kInfinite; }));
  EXPECT_EQ(costmap.shownCost(there), 100);
  costmap.forgetAll();
  EXPECT_EQ(costmap.shownCost(there), 0);
}

TEST(Costmap, refusesMapsAndOptionsThatCannotBe)
{
  const Footprint footprint(defaultFootprint());
  EXPECT_THROWS_MESSAGE(
    Costmap(OccupancyGrid{}, {}, footprint), Error,
    "map: 0 x 0 cells with 0 values, must be at least 2 x 2 with one value each");
  CostmapOptions options;
  options.inflation_radius = -1.0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "inflation_radius: found -1, must be a number above 0");
  options = {};
  options.lethal_cost_threshold = 0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "lethal_cost_threshold: found 0, must be 1 to 100");
}
}  // namespace
}  // namespace move_base
