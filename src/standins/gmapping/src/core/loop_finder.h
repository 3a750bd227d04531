#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pose_graph.h"
#include "scan_matcher.h"
#include "way.h"

namespace gmapping
{
/// Notices that the lidar is where it has been before.
class LoopFinder
{
public:
  explicit LoopFinder(const MatcherOptions & options) : matcher_(options) {}

  /// What the last few metres have shown, laid onto what was seen at the last stop before; nothing if the lidar was not
  /// there before, if that was looked for a moment ago, or if the two do not agree.
  /// @param poses  of the stops, as they are believed to be now
  std::optional<PoseEdge> find(const Way & way, const std::vector<Pose2> & poses);

private:
  /// How far the last stop may be from where it is believed to be, seen from the earlier one.
  struct Doubt
  {
    double position{0.0};  // m, a standard deviation
    double yaw{0.0};       // rad
  };

  Doubt doubt(const Way & way, std::size_t earlier) const;
  std::optional<std::size_t> earlierStop(const Way & way, const std::vector<Pose2> & poses) const;
  std::optional<PoseEdge> match(
    const Way & way, const std::vector<Pose2> & poses, std::size_t earlier, const Doubt & doubt);

  ScanMatcher matcher_;
  double last_search_{0.0};     // m driven then
  std::optional<double> last_;  // m driven when a loop was last known for certain
};
}  // namespace gmapping
