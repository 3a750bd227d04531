#include "move_base/path/path.h"

#include <algorithm>

namespace move_base
{
namespace
{
// [begin, end) of items that agree on the driving direction.
template <class Item, class IsReverse>
std::vector<PathStretch> split(const std::vector<Item> & items, const IsReverse & is_reverse)
{
  std::vector<PathStretch> result;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= items.size(); ++i) {
    if (i == items.size() || is_reverse(items[i]) != is_reverse(items[begin])) {
      result.push_back({begin, i});
      begin = i;
    }
  }
  return result;
}

// Walks along arcs of one direction, forwards only.
class ArcWalker
{
public:
  ArcWalker(const Pose2 & start, const std::vector<Arc> & arcs, const PathStretch & range)
  : arcs_(arcs), arc_(range.begin), last_(range.end - 1), arc_start_(start)
  {
  }

  PathPoint at(double driven)
  {
    while (arc_ < last_ && driven > arc_begin_ + std::abs(arcs_[arc_].length)) {
      arc_begin_ += std::abs(arcs_[arc_].length);
      arc_start_ = advance(arc_start_, arcs_[arc_].length, arcs_[arc_].curvature);
      ++arc_;
    }
    const Arc & arc = arcs_[arc_];
    const double part = std::copysign(driven - arc_begin_, arc.length);
    return {advance(arc_start_, part, arc.curvature), arc.curvature, arc.length < 0.0, driven};
  }

private:
  const std::vector<Arc> & arcs_;
  std::size_t arc_;
  std::size_t last_;
  Pose2 arc_start_;
  double arc_begin_{0.0};
};
}  // namespace

std::vector<PathStretch> stretches(const Path & path)
{
  return split(path, [](const PathPoint & point) { return point.reverse; });
}

bool isForward(const Path & path)
{
  return std::none_of(path.begin(), path.end(), [](const PathPoint & point) { return point.reverse; });
}

Path samplePath(const Pose2 & start, const std::vector<Arc> & arcs, double spacing)
{
  Path path;
  Pose2 pose = start;
  double driven = 0.0;
  for (const PathStretch & range : split(arcs, [](const Arc & arc) { return arc.length < 0.0; })) {
    const double total = length(std::vector<Arc>(
      arcs.begin() + static_cast<std::ptrdiff_t>(range.begin), arcs.begin() + static_cast<std::ptrdiff_t>(range.end)));
    const int steps = std::max(1, static_cast<int>(std::ceil(total / spacing - 1e-9)));
    ArcWalker walker(pose, arcs, range);
    for (int i = 0; i <= steps; ++i) {
      path.push_back(walker.at(total * i / steps));
      path.back().s += driven;
    }
    driven += total;
    pose = path.back().pose;
  }
  if (path.empty()) {
    path.push_back({start, 0.0, false, 0.0});
  }
  return path;
}

double curvatureThrough(const Vec2 & a, const Vec2 & b, const Vec2 & c)
{
  const double lengths = distance(a, b) * distance(b, c) * distance(a, c);
  return lengths > 0.0 ? 2.0 * cross(b - a, c - b) / lengths : 0.0;
}

double length(const Path & path)
{
  return path.empty() ? 0.0 : path.back().s - path.front().s;
}

double length(const std::vector<Arc> & arcs)
{
  double sum = 0.0;
  for (const Arc & arc : arcs) {
    sum += std::abs(arc.length);
  }
  return sum;
}

std::size_t nearestTo(const Path & path, const Pose2 & pose)
{
  const auto nearest = std::min_element(path.begin(), path.end(), [&](const PathPoint & a, const PathPoint & b) {
    return distance(a.pose, pose) < distance(b.pose, pose);
  });
  return static_cast<std::size_t>(nearest - path.begin());
}

std::size_t firstBeyond(const Path & path, double s, std::size_t from)
{
  std::size_t i = from;
  while (i + 1 < path.size() && path[i].s < s) {
    ++i;
  }
  return i;
}
}  // namespace move_base
