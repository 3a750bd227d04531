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
    // Nothing to match to would be there at the next switch but one, if it did not begin with something.
    registerBeams(newer_, beams, pose, max_urange);
  }
}
}  // namespace gmapping
