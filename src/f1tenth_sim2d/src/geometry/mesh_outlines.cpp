#include "geometry/mesh_outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/planar.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

/// Whether the way from a over b to c is straight on, or b is one of the two. A spike, where it turns back, is not.
bool isStraight(const Vec2 & a, const Vec2 & b, const Vec2 & c)
{
  const double first = distance(a, b);
  const double second = distance(b, c);
  const double onwards = dot(b - a, c - b);
  return first <= kTolerance || second <= kTolerance ||
         (onwards > 0.0 && std::abs(turn(a, b, c)) <= kTolerance * (first + second));
}

/// A closed line without the corners at which it goes straight on; spikes stay, a lidar sees them.
Outline withoutStraightCorners(const Outline & outline)
{
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 & before = kept.empty() ? outline.back() : kept.back();
    if (!isStraight(before, outline[i], outline[(i + 1) % outline.size()])) {
      kept.push_back(outline[i]);
    }
  }
  return kept;
}

/// Where the edges of the mesh cross the plane, and the lines between these points, one for each triangle.
class CutLines
{
public:
  CutLines(const TriangleMesh & mesh, const std::vector<Vector3d> & vertices, double z) : vertices_(vertices), z_(z)
  {
    for (const auto & triangle : mesh.triangles) {
      cutTriangle(triangle);
    }
    for (auto & [ends, line] : lines_) {
      touching_[ends.first].push_back(&line);
      touching_[ends.second].push_back(&line);
    }
  }

  MeshOutlines outlines()
  {
    MeshOutlines outlines;
    for (std::size_t start = 0; start < points_.size(); ++start) {
      if (touching_[start].size() % 2 == 1) {
        followFrom(start, outlines);
      }
    }
    for (std::size_t start = 0; start < points_.size(); ++start) {
      while (nextFrom(start) != nullptr) {
        followFrom(start, outlines);
      }
    }
    return outlines;
  }

private:
  using Ends = std::pair<std::size_t, std::size_t>;

  struct Line
  {
    Ends ends;
    int forwards{0};  ///< triangles that have solid matter to the left from first to second end, minus the others
    bool used{false};
  };

  /// A corner exactly in the plane counts as below it: so no line consists of a corner only, and none is missed.
  bool isAbove(std::uint32_t vertex) const { return vertices_[vertex].z() > z_ + kTolerance; }

  void cutTriangle(const std::array<std::uint32_t, 3> & triangle)
  {
    std::array<std::size_t, 2> points{};  // where the way around the triangle goes up, and where it comes down
    bool is_cut = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      if (isAbove(from) != isAbove(to)) {
        is_cut = true;
        points[isAbove(from) ? 1 : 0] = isAbove(from) ? pointOn(to, from) : pointOn(from, to);
      }
    }
    if (is_cut) {
      // Seen from outside with z upwards a counter-clockwise triangle goes up on the right, and outside is on the
      // right of the way around the solid.
      addLine(points[1], points[0]);
    }
  }

  std::size_t pointOn(std::uint32_t below, std::uint32_t above)
  {
    const auto [known, is_new] = point_of_edge_.try_emplace({below, above}, points_.size());
    if (is_new) {
      const Vector3d & a = vertices_[below];
      const Vector3d & b = vertices_[above];
      const double t = std::clamp((z_ - a.z()) / (b.z() - a.z()), 0.0, 1.0);
      points_.push_back({a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y())});
      touching_.emplace_back();
    }
    return known->second;
  }

  void addLine(std::size_t from, std::size_t to)
  {
    const Ends ends = std::minmax(from, to);
    Line & line = lines_.try_emplace(ends, Line{ends}).first->second;
    line.forwards += from == ends.first ? 1 : -1;
  }

  /// How many more triangles have solid matter to the left than to the right of a line that is followed from this end.
  static int forwardsFrom(std::size_t point, const Line & line)
  {
    return point == line.ends.first ? line.forwards : -line.forwards;
  }

  /// The line still to be followed that has solid matter most clearly to its left; null if there is none.
  Line * nextFrom(std::size_t point) const
  {
    Line * best = nullptr;
    for (Line * const line : touching_[point]) {
      if (!line->used && (best == nullptr || forwardsFrom(point, *line) > forwardsFrom(point, *best))) {
        best = line;
      }
    }
    return best;
  }

  void followFrom(std::size_t start, MeshOutlines & outlines)
  {
    Outline outline;
    int forwards = 0;
    std::size_t point = start;
    while (Line * const line = nextFrom(point)) {
      outline.push_back(points_[point]);
      line->used = true;
      forwards += forwardsFrom(point, *line);
      point = point == line->ends.first ? line->ends.second : line->ends.first;
      if (point == start) {
        break;
      }
    }
    if (outline.empty()) {
      return;
    }
    if (point == start) {
      appendClosed(std::move(outline), forwards, outlines);
    } else {
      outline.push_back(points_[point]);
      outlines.open.push_back(std::move(outline));
    }
  }

  /// @param forwards  how many more triangles say that solid matter is to the left; if there is no majority, as where
  ///                  every triangle is there twice for its two sides, the outline encloses solid matter
  static void appendClosed(Outline outline, int forwards, MeshOutlines & outlines)
  {
    const bool is_hollow = forwards != 0 && (forwards > 0) != (signedArea(outline) > 0.0);
    if ((signedArea(outline) < 0.0) != is_hollow) {
      std::reverse(outline.begin(), outline.end());
    }
    outline = withoutStraightCorners(outline);
    if (outline.size() >= 2) {
      outlines.closed.push_back(std::move(outline));
    }
  }

  const std::vector<Vector3d> & vertices_;
  double z_;
  std::vector<Vec2> points_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> point_of_edge_;
  std::map<Ends, Line> lines_;
  std::vector<std::vector<Line *>> touching_;  ///< the lines that end in each point
};
}  // namespace

MeshOutlines outlinesAt(const TriangleMesh & mesh, const std::vector<Vector3d> & vertices, double z)
{
  return CutLines(mesh, vertices, z).outlines();
}
}  // namespace f1tenth_sim2d
