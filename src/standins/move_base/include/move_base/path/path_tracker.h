#pragma once

#include "move_base/path/path.h"

namespace move_base
{
/// Where a car is relative to its path.
struct PathPosition
{
  double s{0.0};              ///< m along the path, at the nearest point
  double remaining{0.0};      ///< m to the end of the stretch of one driving direction
  double lateral{0.0};        ///< m, positive when the car is to the left of the motion along the path
  double heading_error{0.0};  ///< rad, car's heading minus the path's
  double curvature{0.0};      ///< 1/m, wheels' setting at the nearest point
  bool reverse{false};
  std::size_t index{0};  ///< of the point before the nearest one
};

/// Finds a car's place on its path, moving only forwards, so that a path that crosses itself is driven in order.
class PathTracker
{
public:
  PathTracker() = default;
  explicit PathTracker(const Path & path);

  /// The place of a pose, near the place found by the last moveTo.
  PathPosition locate(const Path & path, const Pose2 & pose) const;
  /// The same, and remembers it.
  PathPosition moveTo(const Path & path, const Pose2 & pose);

  /// Goes on to the stretch in the other driving direction, unless it is on the last one.
  void nextStretch();
  bool onLastStretch() const { return stretch_ + 1 >= stretches_.size(); }

private:
  std::vector<PathStretch> stretches_;
  std::size_t stretch_{0};
  std::size_t index_{0};
};
}  // namespace move_base
