#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <vector>

#include "cell_map.h"
#include "gmapping/geometry.h"

namespace gmapping
{
/// A beam that hit something, in the lidar's frame.
struct Beam
{
  float cos{1.0F};    ///< of its direction
  float sin{0.0F};    ///< of its direction
  float range{0.0F};  ///< m
};

/// The beams of a scan that hit something nearer than max_range.
std::vector<Beam> hitBeams(const Scan & scan, double max_range);

/// Where beams ended, in the lidar's frame, m.
std::vector<Vec2> endsOf(const std::vector<Beam> & beams);

/// Where beams and their ends are in the map, of a lidar at pose: `transform`, with sine and cosine taken once.
class BeamCaster
{
public:
  explicit BeamCaster(const Pose2 & pose) : pose_(pose), cos_(maths::cos(pose.yaw)), sin_(maths::sin(pose.yaw)) {}

  Vec2 direction(const Beam & beam) const
  {
    return {cos_ * beam.cos - sin_ * beam.sin, sin_ * beam.cos + cos_ * beam.sin};
  }
  /// @param end  in the lidar's frame, m
  Vec2 place(const Vec2 & end) const
  {
    return {pose_.x + cos_ * end.x - sin_ * end.y, pose_.y + sin_ * end.x + cos_ * end.y};
  }
  /// @param distance  from the lidar, m
  Vec2 along(const Vec2 & direction, double distance) const
  {
    return {pose_.x + distance * direction.x, pose_.y + distance * direction.y};
  }

private:
  Pose2 pose_;
  double cos_;
  double sin_;
};

/// Puts a scan into a map.
/// @param max_urange  m, a longer beam counts up to there, as free
void registerBeams(CellMap & map, const std::vector<Beam> & beams, const Pose2 & pose, double max_urange);
}  // namespace gmapping
