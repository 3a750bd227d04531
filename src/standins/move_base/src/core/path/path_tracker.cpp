#include "move_base/path/path_tracker.h"

#include <algorithm>

namespace move_base
{
namespace
{
constexpr double kSearchAhead = 2.0;   // m
constexpr double kSearchBehind = 0.5;  // m

PathPosition positionOn(
  const Path & path, const PathStretch & stretch, std::size_t index, double part, const Pose2 & pose)
{
  const PathPoint & a = path[index];
  const PathPoint & b = path[std::min(index + 1, stretch.end - 1)];
  PathPosition position;
  position.index = index;
  position.reverse = a.reverse;
  position.s = a.s + part * (b.s - a.s);
  position.remaining = path[stretch.end - 1].s - position.s;
  position.curvature = a.curvature + part * (b.curvature - a.curvature);
  const Pose2 nearest = between(a.pose, b.pose, part);
  position.heading_error = normalizeAngle(pose.yaw - nearest.yaw);
  const Vec2 heading{maths::cos(nearest.yaw), maths::sin(nearest.yaw)};
  const double left = cross(heading, pose.position() - nearest.position());
  position.lateral = a.reverse ? -left : left;
  return position;
}
}  // namespace

PathTracker::PathTracker(const Path & path) : stretches_(stretches(path)) {}

PathPosition PathTracker::locate(const Path & path, const Pose2 & pose) const
{
  const PathStretch & stretch = stretches_[stretch_];
  const double from = path[index_].s - kSearchBehind;
  const double to = path[index_].s + kSearchAhead;
  std::size_t first = index_;
  while (first > stretch.begin && path[first - 1].s >= from) {
    --first;
  }
  std::size_t best = first;
  double best_part = 0.0;
  double best_distance = HUGE_VAL;
  for (std::size_t i = first; i + 1 < stretch.end && path[i].s <= to; ++i) {
    const Vec2 a = path[i].pose.position();
    const Vec2 b = path[i + 1].pose.position();
    const double part = nearestPart(a, b, pose.position());
    const double away = distance(a + part * (b - a), pose.position());
    if (away < best_distance) {
      best = i;
      best_part = part;
      best_distance = away;
    }
  }
  return positionOn(path, stretch, best, best_part, pose);
}

PathPosition PathTracker::moveTo(const Path & path, const Pose2 & pose)
{
  const PathPosition position = locate(path, pose);
  index_ = position.index;
  return position;
}

void PathTracker::nextStretch()
{
  if (!onLastStretch()) {
    ++stretch_;
    index_ = stretches_[stretch_].begin;
  }
}
}  // namespace move_base
