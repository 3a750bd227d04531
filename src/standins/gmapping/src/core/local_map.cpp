#include "local_map.h"

#include <utility>

namespace gmapping
{
namespace
{
// With a tenth of a metre between scans, twice the range of a lidar of 10 m lies behind.
constexpr int kScans = 200;
}  // namespace

void LocalMap::add(const std::vector<Beam> & beams, const Pose2 & pose, double max_urange)
{
  registerBeams(older_, beams, pose, max_urange);
  registerBeams(newer_, beams, pose, max_urange);
  if (++scans_ >= kScans) {
    older_ = std::exchange(newer_, CellMap(kMatchingCell));
    scans_ = 0;
    // It has to begin with something, or there might be nothing to match to at the next switch but one.
    registerBeams(newer_, beams, pose, max_urange);
  }
}
}  // namespace gmapping
