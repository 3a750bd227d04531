#include "core/lidar/scan_space.h"

namespace f1tenth_sim2d
{
ScanSpace::ScanSpace(const Beams & beams, std::size_t items)
: raster(beams), drawn(items), normal(static_cast<std::size_t>(beams.count))
{
}

ScanSpaces::ScanSpaces(const Beams & beams, std::size_t items) : beams_(beams), items_(items)
{
  borrow();
}

ScanSpaces::Loan ScanSpaces::borrow()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (free_.empty()) {
    free_.reserve(spaces_.size() + 1);
    free_.push_back(spaces_.emplace_back(std::make_unique<ScanSpace>(beams_, items_)).get());
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
