#include "wall_search.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

namespace gmapping
{
namespace
{
constexpr double kFine = 0.1;  // m per cell
constexpr int kFinePerCoarse = 5;
constexpr double kCoarse = kFinePerCoarse * kFine;  // m per cell
constexpr double kTurn = 0.015;                     // rad: 15 cm at 10 m
// How much less a place at the edge of the window counts than one in the middle, so that a straight wall is not moved
// along itself for nothing.
constexpr double kDistrust = 0.6;

std::vector<Vec2> turnedBy(const std::vector<Vec2> & points, double yaw)
{
  const double c = maths::cos(yaw);
  const double s = maths::sin(yaw);
  std::vector<Vec2> turned(points.size());
  std::transform(points.begin(), points.end(), turned.begin(), [&](const Vec2 & point) {
    return Vec2{c * point.x - s * point.y, s * point.x + c * point.y};
  });
  return turned;
}
}  // namespace

WallSearch::WallSearch(const std::vector<Vec2> & walls) : fine_(layerOf(walls, kFine)), coarse_(layerOf(walls, kCoarse))
{
}

int WallSearch::Layer::valueAt(const Vec2 & point) const
{
  const Cell cell = geometry.cellAt(point);
  return geometry.contains(cell) ? values[geometry.index(cell)] : 0;
}

/// Cells with a wall or beside one. A coarse cell then has whatever its fine ones have, wherever a step begins.
WallSearch::Layer WallSearch::layerOf(const std::vector<Vec2> & walls, double cell)
{
  Vec2 low{walls.front()};
  Vec2 high{walls.front()};
  for (const Vec2 & wall : walls) {
    low = {std::min(low.x, wall.x), std::min(low.y, wall.y)};
    high = {std::max(high.x, wall.x), std::max(high.y, wall.y)};
  }
  Layer layer{{0, 0, cell, {low.x - 2.0 * cell, low.y - 2.0 * cell, 0.0}}, {}};
  const Cell last = layer.geometry.cellAt(high);
  layer.geometry.width = last.x + 3;
  layer.geometry.height = last.y + 3;
  layer.values.assign(layer.geometry.size(), 0);
  for (const Vec2 & wall : walls) {
    const Cell middle = layer.geometry.cellAt(wall);
    for (int y = middle.y - 1; y <= middle.y + 1; ++y) {
      std::fill_n(&layer.values[layer.geometry.index({middle.x - 1, y})], 3, 1);
    }
  }
  return layer;
}

double WallSearch::score(const Layer & layer, const std::vector<Vec2> & turned, const Vec2 & offset)
{
  int sum = 0;
  for (const Vec2 & point : turned) {
    sum += layer.valueAt(point + offset);
  }
  return static_cast<double>(sum) / static_cast<double>(turned.size());
}

Pose2 WallSearch::best(const std::vector<Vec2> & points, const SearchWindow & window) const
{
  const auto worth = [&](const Layer & layer, const std::vector<Vec2> & turned, const Pose2 & pose) {
    const double away = maths::hypot(pose.x - window.middle.x, pose.y - window.middle.y) / window.reach;
    return score(layer, turned, {pose.x, pose.y}) - kDistrust * away * away;
  };
  std::vector<Candidate> coarse;
  const int turns = static_cast<int>(std::ceil(window.turn / kTurn));
  const int steps = static_cast<int>(std::ceil(window.reach / kCoarse));
  for (int i = -turns; i <= turns; ++i) {
    const double yaw = window.middle.yaw + i * kTurn;
    const std::vector<Vec2> turned = turnedBy(points, yaw);
    for (int x = -steps; x <= steps; ++x) {
      for (int y = -steps; y <= steps; ++y) {
        const Pose2 pose{window.middle.x + x * kCoarse, window.middle.y + y * kCoarse, yaw};
        coarse.push_back({pose, score(coarse_, turned, {pose.x, pose.y})});
      }
    }
  }
  std::stable_sort(
    coarse.begin(), coarse.end(), [](const Candidate & a, const Candidate & b) { return a.score > b.score; });
  Candidate best{window.middle, worth(fine_, turnedBy(points, window.middle.yaw), window.middle)};
  for (const Candidate & candidate : coarse) {
    if (candidate.score <= best.score) {
      break;
    }
    const std::vector<Vec2> turned = turnedBy(points, candidate.pose.yaw);
    constexpr int kSteps = (kFinePerCoarse + 1) / 2;
    for (int x = -kSteps; x <= kSteps; ++x) {
      for (int y = -kSteps; y <= kSteps; ++y) {
        const Pose2 pose{candidate.pose.x + x * kFine, candidate.pose.y + y * kFine, candidate.pose.yaw};
        const double found = worth(fine_, turned, pose);
        best = found > best.score ? Candidate{pose, found} : best;
      }
    }
  }
  return best.pose;
}

double WallSearch::share(const std::vector<Vec2> & points, const Pose2 & pose) const
{
  return score(fine_, turnedBy(points, pose.yaw), {pose.x, pose.y});
}
}  // namespace gmapping
