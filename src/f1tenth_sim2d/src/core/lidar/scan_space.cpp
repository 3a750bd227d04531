#include "core/lidar/scan_space.h"

#include <tuple>

namespace f1tenth_sim2d
{
namespace
{
auto beamsOf(const LidarDescription & lidar)
{
  return std::tie(lidar.beam_count, lidar.angle_min, lidar.angle_max);
}
}  // namespace

ScanSpace::ScanSpace(const LidarDescription & lidar, std::size_t items)
: raster(lidar), drawn(items), normal(static_cast<std::size_t>(raster.beamCount()))
{
}

ScanSpaces::ScanSpaces(const LidarDescription & lidar, std::size_t items) : lidar_(lidar), items_(items)
{
  borrow();
}

bool ScanSpaces::fit(const LidarDescription & lidar) const
{
  return beamsOf(lidar) == beamsOf(lidar_);
}

ScanSpaces::Loan ScanSpaces::borrow()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (free_.empty()) {
    free_.reserve(spaces_.size() + 1);
    free_.push_back(spaces_.emplace_back(std::make_unique<ScanSpace>(lidar_, items_)).get());
  }
  ScanSpace * space = free_.back();
  free_.pop_back();
  return Loan(space, GiveBack(*this));
}

// There is room: borrow() reserved it for all of them.
void ScanSpaces::takeBack(ScanSpace * space) noexcept
{
  const std::lock_guard<std::mutex> lock(mutex_);
  free_.push_back(space);
}
}  // namespace f1tenth_sim2d
