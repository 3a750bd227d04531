#include "line/path_extension.h"

#include <gtest/gtest.h>

#include "roads.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawMap;
using testing::inRectangle;
using testing::makeCostmap;

// A hall of 4 m along x that ends at x = 12 m; a lane of 2 m leads out of it to the left before.
OccupancyGrid drawHallWithLane()
{
  return drawMap(13.0, 20.0, [](const Vec2 & p) {
    const bool hall = inRectangle(p, {0.1, 2.0}, {12.0, 6.0});
    const bool lane = inRectangle(p, {7.5, 2.0}, {9.5, 19.9});
    return !hall && !lane;
  });
}

TEST(ExtensionFrom, findsTheWayOutBesideADeadEnd)
{
  const Costmap costmap = makeCostmap(drawHallWithLane());
  const Pose2 start{2.0, 4.0, 0.0};
  const ClearanceRule rule(costmap, start, start, 0.1);
  const std::vector<Arc> arcs = extensionFrom(start, costmap, rule, PlannerOptions(), 16.0);
  ASSERT_GE(length(arcs), 16.0);
  EXPECT_GT(samplePath(start, arcs, 0.1).back().pose.y, 8.0);
}

TEST(ExtensionFrom, goesAsFarAsItCan)
{
  const Costmap costmap = makeCostmap(testing::drawRoom(8.0, 2.0));
  const Pose2 start{2.0, 1.0, 0.0};
  const ClearanceRule rule(costmap, start, start, 0.1);
  const double reached = length(extensionFrom(start, costmap, rule, PlannerOptions(), 16.0));
  EXPECT_GT(reached, 4.5);
  EXPECT_LT(reached, 6.0);
}
}  // namespace
}  // namespace f1tenth_racer
