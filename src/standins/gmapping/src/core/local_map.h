#pragma once

#include <vector>

#include "beams.h"
#include "cell_map.h"
#include "scan_matcher.h"

namespace gmapping
{
/// A map of the way that lies just behind: scans are matched to it, at a cost that does not grow with the way.
class LocalMap
{
public:
  /// Of the last kScans to 2 kScans scans.
  const CellMap & map() const { return older_; }
  void add(const std::vector<Beam> & beams, const Pose2 & pose, double max_urange);

private:
  CellMap older_{kMatchingCell};
  CellMap newer_{kMatchingCell};
  int scans_{0};
};
}  // namespace gmapping
