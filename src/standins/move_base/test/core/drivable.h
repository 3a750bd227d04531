#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "move_base/planning/way_planner.h"

/// What tests of planners ask of their paths.
namespace move_base::testing
{
inline PlannerOptions forwardOnly()
{
  PlannerOptions options;
  options.allow_reversing = false;
  return options;
}

inline void expectDrivable(const Plan & plan, const Costmap & costmap, const PlannerOptions & options)
{
  // Three points of a path that was rounded give a curvature this much off.
  constexpr double kCurvatureTolerance = 1.02;
  ASSERT_TRUE(plan.found()) << static_cast<int>(plan.status);
  for (std::size_t i = 0; i < plan.path.size(); ++i) {
    const PathPoint & point = plan.path[i];
    EXPECT_LE(std::abs(point.curvature), kCurvatureTolerance / options.min_turning_radius) << i;
    EXPECT_GE(costmap.clearance(point.pose), 0.0) << i;
    if (i > 0) {
      const PathPoint & before = plan.path[i - 1];
      EXPECT_NEAR(point.s - before.s, distance(before.pose, point.pose), 0.005) << i;
      EXPECT_LE(point.s - before.s, 0.15) << i;
      const Vec2 along = transform({0.0, 0.0, -before.pose.yaw}, point.pose.position() - before.pose.position());
      EXPECT_LE(std::abs(along.y), 0.01) << "sideways at " << i;
    }
  }
}
}  // namespace move_base::testing
