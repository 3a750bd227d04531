#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "core/lidar/range_raster.h"
#include "core/lidar/wall_grid.h"

namespace f1tenth_sim2d
{
/// Working memory of a scan. Large, and meaningless between two scans.
struct ScanSpace
{
  /// @param items  of the walls, as WallGrid counts them
  ScanSpace(const Beams & beams, std::size_t items);

  RangeRaster raster;
  DrawnItems drawn;
  std::vector<double> normal;  ///< standard normal noise
};

/// The spaces of all lidars with the same beams in the same walls, each lent for one scan. There are as many as threads
/// have scanned at once, however many cars and simulations there are. For any thread.
class ScanSpaces
{
public:
  /// Makes the first space.
  ScanSpaces(const Beams & beams, std::size_t items);

  const Beams & beams() const { return beams_; }

  class GiveBack
  {
  public:
    explicit GiveBack(ScanSpaces & owner) : owner_(&owner) {}
    void operator()(ScanSpace * space) const { owner_->takeBack(space); }

  private:
    ScanSpaces * owner_;
  };
  using Loan = std::unique_ptr<ScanSpace, GiveBack>;

  /// Allocates nothing, unless all existing ones are lent.
  Loan borrow();

private:
  void takeBack(ScanSpace * space) noexcept;

  const Beams beams_;
  const std::size_t items_;
  std::mutex mutex_;  ///< guards what follows
  std::vector<std::unique_ptr<ScanSpace>> spaces_;
  std::vector<ScanSpace *> free_;
};
}  // namespace f1tenth_sim2d
