#pragma once

#include <cstddef>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// A pose as seen from a course (Frenet's coordinates).
struct CoursePosition
{
  double distance{0.0};  ///< m, along the course from its first point to the nearest one, less than its length
  double offset{0.0};    ///< m, to the left of the course
  double heading{0.0};   ///< rad, from the direction of the course, in [-pi, pi]
};

/// A closed line that is driven in the order of its points, such as the centreline of a race track.
class Course
{
public:
  /// @param points  m, in the world; the last one is joined to the first
  /// @throws Error for fewer than three points, one that is not finite or the same as the one before
  explicit Course(std::vector<Vec2> points);

  double length() const { return distances_.back(); }  ///< m

  /// The pose at a distance along the course, m, and an offset to its left, m, headed along it.
  Pose2 pose(double distance, double offset) const;

  /// Seen from the nearest point of the whole course.
  CoursePosition locate(const Pose2 & pose) const;
  /// Seen from the nearest point within `reach` of a distance along the course (m), so that no car jumps to another
  /// part of the road that comes close.
  CoursePosition locate(const Pose2 & pose, double near, double reach) const;

private:
  /// @param index  up to the number of points, which is the first one again
  const Vec2 & point(std::size_t index) const { return points_[index < points_.size() ? index : 0]; }
  std::size_t segmentAt(double distance) const;
  double wrapped(double distance) const;
  CoursePosition nearest(const Pose2 & pose, std::size_t first, std::size_t count) const;

  std::vector<Vec2> points_;
  std::vector<double> distances_;  ///< of each point from the first; one more than points: the length
};
}  // namespace f1tenth_sim2d
