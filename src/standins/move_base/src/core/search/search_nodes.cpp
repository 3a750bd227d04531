#include "search/search_nodes.h"

namespace move_base
{
namespace
{
// Smaller than half of a search arc, so that an arc always leads to another bin.
constexpr double kPositionBin = 0.12;
constexpr int kHeadingBins = 72;
constexpr int kNone = -1;

GridGeometry binsOver(const GridGeometry & area)
{
  GridGeometry bins = area;
  bins.resolution = kPositionBin;
  bins.width = static_cast<int>(area.width * area.resolution / kPositionBin) + 1;
  bins.height = static_cast<int>(area.height * area.resolution / kPositionBin) + 1;
  return bins;
}
}  // namespace

SearchNodes::SearchNodes(const GridGeometry & area) : bins_(binsOver(area)), blocks_(bins_.size(), kNone) {}

int & SearchNodes::binOf(const Pose2 & pose)
{
  int & block = blocks_[bins_.index(bins_.cellAt(pose.position()))];
  if (block == kNone) {
    block = static_cast<int>(headings_.size());
    headings_.resize(headings_.size() + kHeadingBins, kNone);
  }
  const double turn = normalizeAngle(pose.yaw) / (2.0 * M_PI) + 0.5;
  const int heading = static_cast<int>(std::lround(turn * kHeadingBins)) % kHeadingBins;
  return headings_[static_cast<std::size_t>(block) + static_cast<std::size_t>(heading)];
}
}  // namespace move_base
