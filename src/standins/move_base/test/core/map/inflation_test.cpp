#include "move_base/map/inflation.h"

#include <gtest/gtest.h>

#include "map/rolling_layer.h"
#include "move_base/map/costmap.h"
#include "rooms.h"

namespace move_base
{
namespace
{
using testing::drawRoom;
using testing::makeCostmap;
using testing::scanFrom;

constexpr double kGridCell = 0.05;

// One obstacle in a grid of 41 x 41 cells; columns beyond the 25th are unknown.
std::vector<std::int8_t> costsAroundOneObstacle(const Inflation & inflation, const GridGeometry & geometry)
{
  std::vector<std::int8_t> cells(geometry.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] = geometry.cell(i).x > 25 ? std::int8_t{-1} : std::int8_t{0};
  }
  cells[geometry.index({20, 20})] = 100;
  return inflated(cells, geometry, inflation);
}

TEST(Inflation, givesTheCostsOfTheOriginal)
{
  const GridGeometry geometry{41, 41, kGridCell, {}};
  const auto costs = costsAroundOneObstacle({0.55, 10.0, 0.1286}, geometry);
  const auto at = [&](int x, int y) { return static_cast<int>(costs[geometry.index({x, y})]); };
  EXPECT_EQ(at(20, 20), 100);
  EXPECT_EQ(at(18, 20), 99) << "0.1 m: the car surely touches it";
  // costmap_2d: 252 exp(-10 (d - 0.1286)) cut to a whole number, 1 to 252 shown as 1 to 98.
  EXPECT_EQ(at(17, 20), 1 + 97 * (203 - 1) / 251) << "0.15 m";
  EXPECT_EQ(at(16, 20), 1 + 97 * (123 - 1) / 251) << "0.2 m";
  EXPECT_EQ(at(16, 17), 1 + 97 * (74 - 1) / 251) << "0.25 m";
  EXPECT_EQ(at(9, 20), 1 + 97 * (3 - 1) / 251) << "0.55 m";
  EXPECT_EQ(at(8, 20), 0) << "0.6 m";
}

TEST(Inflation, leavesUnknownCellsUnknownUnlessTheCarTouchesThere)
{
  const GridGeometry geometry{41, 41, kGridCell, {}};
  const auto costs = costsAroundOneObstacle({0.55, 10.0, 0.4}, geometry);
  EXPECT_EQ(costs[geometry.index({27, 20})], 99) << "0.35 m";
  EXPECT_EQ(costs[geometry.index({29, 20})], -1) << "0.45 m";
}

TEST(Inflation, goesOnBehindUnknownCells)
{
  const GridGeometry geometry{9, 1, kGridCell, {}};
  const auto costs = inflated({100, -1, -1, -1, 0, 0, 0, 0, 0}, geometry, {0.55, 10.0, 0.05});
  EXPECT_EQ(costs[1], 99);
  EXPECT_EQ(costs[2], -1);
  EXPECT_EQ(costs[4], 1 + 97 * (56 - 1) / 251) << "0.2 m";
}

TEST(Inflation, takesObstaclesInLater)
{
  OccupancyGrid map = drawRoom(10.0, 4.0);
  for (int x = 70; x < 90; ++x) {
    map.cells[map.geometry.index({x, 35})] = -1;
  }
  Costmap costmap = makeCostmap(map);
  const GridGeometry & geometry = costmap.geometry();
  const auto before = inflated(costmap.mapCells(), geometry, costmap.inflation());
  costmap.observe(scanFrom({2.0, 2.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 2.0 : 20.0; }));
  OccupancyGrid shown{geometry, before};
  addObstacles(shown, costmap.liveCells(), costmap.inflation());
  std::vector<std::int8_t> cells = costmap.mapCells();
  for (const Cell & cell : costmap.liveCells()) {
    cells[geometry.index(cell)] = 100;
  }
  EXPECT_EQ(shown.cells, inflated(cells, geometry, costmap.inflation()));
  EXPECT_NE(shown.cells, before);
  costmap.forgetAll();
  EXPECT_TRUE(costmap.liveCells().empty());
}

TEST(Inflation, takesObstaclesInAtTheEdgesAndAmongUnknownCells)
{
  const GridGeometry geometry{41, 17, kGridCell, {}};
  const Inflation inflation{0.55, 10.0, 0.1286};
  std::vector<std::int8_t> cells(geometry.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] = geometry.cell(i).x % 7 < 3 ? std::int8_t{-1} : std::int8_t{0};
  }
  OccupancyGrid costs{geometry, inflated(cells, geometry, inflation)};
  const std::vector<Cell> obstacles{{0, 0}, {40, 3}, {20, 16}, {21, 16}, {23, 8}};
  addObstacles(costs, obstacles, inflation);
  for (const Cell & obstacle : obstacles) {
    cells[geometry.index(obstacle)] = 100;
  }
  EXPECT_EQ(costs.cells, inflated(cells, geometry, inflation));
}

class Rolling : public ::testing::Test
{
protected:
  int at(double x, double y) const { return layer_.cells()[layer_.geometry().index(layer_.geometry().cellAt({x, y}))]; }

  RollingLayer layer_{4.0, 4.0, kGridCell, {}};
};

TEST_F(Rolling, hasItsSizeWhereverTheCarIs)
{
  for (const Vec2 & car : {Vec2{0.0, 0.0}, Vec2{-3.33, 100.01}}) {
    layer_.moveTo(car);
    EXPECT_EQ(layer_.cells().size(), 80U * 80U);
    const Vec2 middle = layer_.geometry().origin.position() + Vec2{2.0, 2.0};
    EXPECT_NEAR(middle.x, car.x, 0.51 * kGridCell);
    EXPECT_NEAR(middle.y, car.y, 0.51 * kGridCell);
  }
}

TEST_F(Rolling, marksWhatIsHitAndClearsWhatIsSeenThrough)
{
  layer_.moveTo({5.0, 5.0});
  layer_.observe(scanFrom({5.0, 5.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 1.01 : 20.0; }));
  EXPECT_EQ(at(6.01, 5.0), 100);
  EXPECT_EQ(at(5.9, 5.0), 0);
  layer_.observe(scanFrom({5.0, 5.0, 0.0}, [](double) { return 20.0; }));
  EXPECT_EQ(at(6.01, 5.0), 0);
}

TEST_F(Rolling, keepsWhatStaysInTheWindow)
{
  layer_.moveTo({5.0, 5.0});
  layer_.observe(scanFrom({5.0, 5.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 1.01 : 20.0; }));
  layer_.moveTo({5.5, 4.5});
  EXPECT_EQ(at(6.01, 5.0), 100);
  layer_.moveTo({9.5, 5.0});
  layer_.moveTo({5.0, 5.0});
  EXPECT_EQ(at(6.01, 5.0), 0) << "it had left";
}
}  // namespace
}  // namespace move_base
