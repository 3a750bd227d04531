#include "line/resample.h"

#include <algorithm>

namespace f1tenth_racer
{
Path pathThrough(const std::vector<Vec2> & points, const PathPoint & start)
{
  Path path(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 & before = points[i == 0 ? 0 : i - 1];
    const Vec2 & after = points[std::min(i + 1, points.size() - 1)];
    const Vec2 along = after - before;
    path[i].pose = {points[i].x, points[i].y, maths::atan2(along.y, along.x)};
    path[i].s = i == 0 ? start.s : path[i - 1].s + distance(points[i - 1], points[i]);
    if (i > 0 && i + 1 < points.size()) {
      path[i].curvature = curvatureThrough(before, points[i], after);
    }
  }
  path.front().pose.yaw = start.pose.yaw;
  path.front().curvature = start.curvature;
  path.back().curvature = path[path.size() - 2].curvature;
  return path;
}

Path resampled(const Path & path)
{
  std::vector<Vec2> points;
  std::size_t i = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const double s = path.front().s + length(path) * static_cast<double>(k) / static_cast<double>(path.size() - 1);
    while (i + 2 < path.size() && path[i + 1].s <= s) {
      ++i;
    }
    const double part = (s - path[i].s) / (path[i + 1].s - path[i].s);
    // On the arc between the neighbours, not on the chord: chords would take curvature away in every round.
    const Vec2 chord = path[i + 1].pose.position() - path[i].pose.position();
    const double bend = 0.5 * (path[i].curvature + path[i + 1].curvature);
    const double bow = -0.5 * bend * part * (1.0 - part) * norm(chord);
    points.push_back(path[i].pose.position() + part * chord + bow * Vec2{-chord.y, chord.x});
  }
  points.push_back(path.back().pose.position());
  return pathThrough(points, path.front());
}
}  // namespace f1tenth_racer
