#include "scan_matcher.h"

#include <workspace_support/maths/exponential.h>
#include <workspace_support/maths/trigonometry.h>
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "beams.h"

namespace gmapping
{
namespace
{
// Share of beams that end in a cell above which it may be part of a wall; less than for a published cell, as a cell
// that is often grazed is still a wall. With 0.1 the cells on the near side of a wall are missing, and it seems to lie
// farther away.
constexpr double kWallShare = 0.05;
// A cell that was hit often is well known, but the neighbours count, too.
constexpr std::uint32_t kMostHits = 50;
// Only the tips of the pixels of a wall far ahead are seen at first, so that it seems to lie nearer than it does from
// close by: what few beams have found counts less, by half with this many around an end.
constexpr double kFewHits = 25.0;
// Far beams may be off by more than sigma at first: the search begins with wider tolerance.
constexpr double kFirstSigmas[] = {2.0, 1.0};
constexpr double kSmallStep = 1e-5;  // m and rad

double gaussian(double distance, double sigma)
{
  return maths::exp(-0.5 * distance * distance / (sigma * sigma));
}

double weightOf(const MapCell & cell)
{
  return std::min(cell.hits, kMostHits);
}

Eigen::Vector3d difference(const Pose2 & a, const Pose2 & b)
{
  return {a.x - b.x, a.y - b.y, normalizeAngle(a.yaw - b.yaw)};
}
}  // namespace

Eigen::Matrix3d turnMatrix(double yaw)
{
  const maths::SineCosine at = maths::sineCosine(yaw);
  Eigen::Matrix3d turn;
  turn << at.cosine, -at.sine, 0.0, at.sine, at.cosine, 0.0, 0.0, 0.0, 1.0;
  return turn;
}

PoseBelief ScanMatcher::match(const CellMap & map, const std::vector<Vec2> & ends, const PoseBelief & expected) const
{
  PoseBelief belief = expected;
  for (const double factor : kFirstSigmas) {
    for (int i = 0; i < options_.iterations; ++i) {
      const Pose2 before = belief.mean;
      belief = step(map, ends, expected, before, factor * options_.sigma);
      if (difference(belief.mean, before).cwiseAbs().maxCoeff() < kSmallStep) {
        break;
      }
    }
  }
  return belief;
}

PoseBelief ScanMatcher::step(
  const CellMap & map, const std::vector<Vec2> & ends, const PoseBelief & expected, const Pose2 & pose,
  double sigma) const
{
  PoseBelief next = expected;
  Eigen::Vector3d pull = expected.information * difference(expected.mean, pose);
  forEachEnd(ends, pose, [&](const Vec2 & end) {
    if (const auto wall = wallNear(map, end)) {
      const Vec2 & n = wall->normal;
      const double distance = wall->distance();
      const double weight = wall->trust * gaussian(distance, sigma) / (options_.sigma * options_.sigma);
      // How the end moves along the normal with x, y and yaw.
      const Eigen::Vector3d slope(n.x, n.y, n.y * (end.x - pose.x) - n.x * (end.y - pose.y));
      next.information += weight * slope * slope.transpose();
      pull += weight * distance * slope;
    }
  });
  const Eigen::Vector3d move = next.information.ldlt().solve(pull);
  next.mean = {pose.x + move.x(), pose.y + move.y(), normalizeAngle(pose.yaw + move.z())};
  return next;
}

double ScanMatcher::score(const CellMap & map, const std::vector<Vec2> & ends, const Pose2 & pose) const
{
  double sum = 0.0;
  forEachEnd(ends, pose, [&](const Vec2 & end) {
    const auto wall = wallNear(map, end);
    sum += wall ? gaussian(wall->distance(), options_.sigma) : 0.0;
  });
  return sum;
}

template <class Visit>
void ScanMatcher::forEachEnd(const std::vector<Vec2> & ends, const Pose2 & pose, Visit visit) const
{
  const BeamCaster caster(pose);
  for (std::size_t i = 0; i < ends.size(); i += options_.lskip + 1) {
    visit(caster.place(ends[i]));
  }
}

template <class Visit>
void ScanMatcher::forEachWallCell(const CellMap & map, const Cell & centre, Visit visit) const
{
  for (int dx = -options_.kernel_size; dx <= options_.kernel_size; ++dx) {
    for (int dy = -options_.kernel_size; dy <= options_.kernel_size; ++dy) {
      const Cell index{centre.x + dx, centre.y + dy};
      const MapCell * cell = map.cell(index);
      if (cell != nullptr && cell->occupied(kWallShare)) {
        visit(index, *cell);
      }
    }
  }
}

Moments ScanMatcher::wallAround(const CellMap & map, const Cell & centre, const Vec2 & place) const
{
  Moments moments;
  forEachWallCell(map, centre, [&](const Cell & index, const MapCell & cell) {
    const Vec2 mean = map.meanHit(index, cell);
    // From the place, as differences of large numbers would lose their digits.
    moments.add({mean.x - place.x, mean.y - place.y}, weightOf(cell));
  });
  return moments;
}

std::optional<ScanMatcher::Wall> ScanMatcher::wallNear(const CellMap & map, const Vec2 & place) const
{
  const Cell end = map.index(place);
  const Moments wall = wallAround(map, end, place);
  const auto normal = wall.normal();
  if (!normal) {
    return std::nullopt;
  }
  // Where a wall has corners, as pixels have, the mean lies beside all of its faces. What taking the mean once more
  // does to it is taken away from it (Tukey's twicing).
  Moments twice;
  double hits = 0.0;
  forEachWallCell(map, end, [&](const Cell & index, const MapCell & cell) {
    twice.add(wallAround(map, index, place).mean(), weightOf(cell));
    hits += cell.hits;
  });
  const Vec2 once = wall.mean();
  const Vec2 offset{2.0 * once.x - twice.mean().x, 2.0 * once.y - twice.mean().y};
  return Wall{offset, *normal, hits / (hits + kFewHits)};
}
}  // namespace gmapping
