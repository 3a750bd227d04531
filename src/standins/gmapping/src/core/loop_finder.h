#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "beams.h"
#include "pose_graph.h"
#include "scan_matcher.h"

namespace gmapping
{
/// A scan that counted.
struct Stop
{
  Pose2 local;              ///< of the lidar, from ScanTracker: smooth, but it drifts
  std::vector<Beam> beams;  ///< what was hit
  double distance{0.0};     ///< driven until here, m
};

/// All of them, in order.
using Way = std::vector<Stop>;

/// Notices that the lidar is where it has been before.
class LoopFinder
{
public:
  explicit LoopFinder(const MatcherOptions & options) : matcher_(options) {}

  /// What the last few metres have shown, matched to what was seen at the last stop before; nothing if the lidar was
  /// not there before, if that was looked for a moment ago, or if the two do not agree.
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
