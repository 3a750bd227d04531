#include "environment/course.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
Course::Course(std::vector<Vec2> points) : points_(std::move(points)), distances_{0.0}
{
  if (points_.size() < 3) {
    throw Error("a course of " + std::to_string(points_.size()) + " points, allowed are 3 or more");
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double step = distance(point(i), point(i + 1));
    if (!(std::isfinite(step) && step > 0.0)) {
      throw Error(
        "point " + std::to_string(i) +
        " of the course is not finite, or the same as the next one, which is not allowed");
    }
    distances_.push_back(distances_.back() + step);
  }
}

double Course::wrapped(double distance) const
{
  const double rest = std::fmod(distance, length());
  return rest < 0.0 ? rest + length() : rest;
}

std::size_t Course::segmentAt(double distance) const
{
  const auto after = std::upper_bound(distances_.begin(), distances_.end(), wrapped(distance));
  const auto index = static_cast<std::size_t>(after - distances_.begin()) - 1;
  return std::min(index, points_.size() - 1);
}

Pose2 Course::pose(double distance, double offset) const
{
  const std::size_t segment = segmentAt(distance);
  const Vec2 along = point(segment + 1) - point(segment);
  const double yaw = maths::atan2(along.y, along.x);
  const Vec2 place = workspace_support::transform(
    {point(segment).x, point(segment).y, yaw}, {wrapped(distance) - distances_[segment], offset});
  return {place.x, place.y, yaw};
}

CoursePosition Course::locate(const Pose2 & pose) const
{
  return nearest(pose, 0, points_.size());
}

CoursePosition Course::locate(const Pose2 & pose, double near, double reach) const
{
  if (2.0 * reach >= length()) {
    return locate(pose);
  }
  const std::size_t first = segmentAt(near - reach);
  const std::size_t last = segmentAt(near + reach);
  return nearest(pose, first, (last + points_.size() - first) % points_.size() + 1);
}

CoursePosition Course::nearest(const Pose2 & pose, std::size_t first, std::size_t count) const
{
  struct
  {
    std::size_t segment{0};
    double part{0.0};
    double square{std::numeric_limits<double>::infinity()};
  } best;
  for (std::size_t i = first; i < first + count; ++i) {
    const std::size_t segment = i < points_.size() ? i : i - points_.size();
    const Vec2 along = point(segment + 1) - point(segment);
    const Vec2 there = pose.position() - point(segment);
    const double size = distances_[segment + 1] - distances_[segment];
    const double part = std::clamp(dot(there, along) / (size * size), 0.0, 1.0);
    const Vec2 off = there - part * along;
    const double square = dot(off, off);
    if (square < best.square) {
      best = {segment, part, square};
    }
  }
  const Vec2 along = point(best.segment + 1) - point(best.segment);
  const Vec2 there = pose.position() - point(best.segment);
  const double size = distances_[best.segment + 1] - distances_[best.segment];
  return {
    wrapped(distances_[best.segment] + best.part * size), std::copysign(std::sqrt(best.square), cross(along, there)),
    workspace_support::normalizeAngle(pose.yaw - maths::atan2(along.y, along.x))};
}
}  // namespace f1tenth_sim2d
