#include "search/search_nodes.h"

namespace move_base
{
namespace
{
// Smaller than half of a search arc, so that an arc always leads to another bin.
constexpr double kPositionBin = 0.12;
constexpr int kHeadingBins = 72;
constexpr int kNone = -1;
}  // namespace

SearchNodes::SearchNodes(const Pose2 & corner) : grid_{0, 0, kPositionBin, corner} {}

int & SearchNodes::binOf(const Pose2 & pose)
{
  const Cell cell = grid_.cellAt(pose.position());
  const double turn = normalizeAngle(pose.yaw) / (2.0 * M_PI) + 0.5;
  const long heading = std::lround(turn * kHeadingBins) % kHeadingBins;
  const auto part = [](long value, unsigned shift) { return static_cast<std::uint64_t>(value) << shift; };
  return bins_.try_emplace(part(cell.y, 40) | part(cell.x, 8) | part(heading, 0), kNone).first->second;
}
}  // namespace move_base
