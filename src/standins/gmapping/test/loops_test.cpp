#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "loop_finder.h"
#include "pose_graph.h"
#include "rooms.h"

namespace gmapping
{
namespace
{
/// What a lidar sees on a straight road of 2 m that never ends, within 10 m.
std::vector<Beam> straightRoad()
{
  std::vector<Beam> beams;
  for (int i = -540; i <= 540; ++i) {
    const double angle = 0.25 * i * M_PI / 180.0;
    const double range = 1.0 / std::max(1e-9, std::abs(std::sin(angle)));
    if (range < 10.0) {
      beams.push_back(
        {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), static_cast<float>(range)});
    }
  }
  return beams;
}

PoseEdge edgeBetween(std::size_t from, std::size_t to, const Pose2 & relative)
{
  return {from, to, relative, 1e4 * Eigen::Matrix3d::Identity()};
}

TEST(LoopFinder, StraightRoadTellsHeadingAndSideButNotHowFarAlongItTheLidarIs)
{
  Way way;
  std::vector<Pose2> poses;
  for (int lap = 0; lap < 2; ++lap) {
    for (int i = 0; i < 40; ++i) {
      const double x = 0.5 * i;
      way.push_back({{x + 100.0 * lap, 0.0, 0.0}, straightRoad(), x + 100.0 * lap});
      poses.push_back({x + 0.3 * lap, 0.05 * lap, 0.0});
    }
  }
  const auto loop = LoopFinder(MatcherOptions()).find(way, poses);
  ASSERT_TRUE(loop);
  EXPECT_FALSE(loop->is_firm);
  EXPECT_NEAR(loop->relative.y, 0.0, 0.01);
  const Eigen::Matrix3d covariance = loop->information.inverse();
  EXPECT_GT(std::sqrt(covariance(0, 0)), 10.0);
  EXPECT_LT(std::sqrt(covariance(2, 2)), 0.01);
}

TEST(LoopFinder, StopsBeforeTheLastOneTellWhereItIs)
{
  Way way;
  std::vector<Pose2> poses;
  for (int lap = 0; lap < 2; ++lap) {
    for (int i = 0; i < 40; ++i) {
      const Pose2 truth{-2.0 + 0.1 * i, 0.0, 0.0};
      way.push_back({truth, hitBeams(scanInRoom(truth), 10.0), 100.0 * lap + 0.5 * i});
      poses.push_back({truth.x + 0.1 * lap, 0.04 * lap, 0.0});
    }
  }
  way.back().beams.resize(1);
  const auto loop = LoopFinder(MatcherOptions()).find(way, poses);
  ASSERT_TRUE(loop);
  EXPECT_TRUE(loop->is_firm);
  EXPECT_NEAR(loop->relative.x, way.back().local.x - way[loop->from].local.x, 0.005);
  EXPECT_NEAR(loop->relative.y, 0.0, 0.005);
}

TEST(PoseGraph, LoopsThatDoNotHoldInEveryDirectionCanBeTakenOut)
{
  PoseGraph graph;
  for (std::size_t i = 0; i < 3; ++i) {
    graph.add({static_cast<double>(i), 0.0, 0.0});
  }
  graph.connect(edgeBetween(0, 1, {1.0, 0.0, 0.0}));
  graph.connect(edgeBetween(1, 2, {1.0, 0.0, 0.0}));
  PoseEdge loose = edgeBetween(0, 2, {2.02, 0.0, 0.0});
  loose.is_loop = true;
  loose.is_firm = false;
  graph.connect(loose);
  graph.optimize();
  EXPECT_GT(graph.poses()[2].x, 2.005);
  graph.keepFirm();
  graph.optimize();
  EXPECT_NEAR(graph.poses()[2].x, 2.0, 1e-6);
}
}  // namespace
}  // namespace gmapping
