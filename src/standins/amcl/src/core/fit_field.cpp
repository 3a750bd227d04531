#include "fit_field.h"

#include <algorithm>
#include <cmath>

namespace amcl
{
namespace
{
constexpr float kWall = 0.3F;           // probability to be free of cells that are walls
constexpr float kFreeNeighbour = 0.7F;  // and of those that are not
constexpr double kReach = 2.5;          // standard deviations
constexpr int kFull = 255;              // stands for 1

/// Whether it is a wall beside what is free: no beam ends farther inside.
bool isSurface(const mrpt::maps::COccupancyGridMap2D & map, int column, int row)
{
  if (map.getCell(column, row) >= kWall) {
    return false;
  }
  for (int i = 0; i < 9; ++i) {
    if (map.getCell(column + i % 3 - 1, row + i / 3 - 1) > kFreeNeighbour) {  // not so outside of the map
      return true;
    }
  }
  return false;
}
}  // namespace

FitField::FitField(const mrpt::maps::COccupancyGridMap2D & map, double slack, double deviation)
: columns_(static_cast<int>(map.getSizeX())),
  rows_(static_cast<int>(map.getSizeY())),
  reach_(static_cast<int>(std::ceil((slack + kReach * deviation) / map.getResolution()))),
  cells_per_metre_(1.0 / map.getResolution()),
  values_(static_cast<std::size_t>(columns_) * rows_, 0)
{
  for (int y = -reach_; y <= reach_; ++y) {
    for (int x = -reach_; x <= reach_; ++x) {
      const double away = std::max(0.0, std::hypot(x, y) / cells_per_metre_ - slack) / deviation;
      kernel_.push_back(static_cast<std::uint8_t>(std::lround(kFull * std::exp(-0.5 * away * away))));
    }
  }
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (isSurface(map, column, row)) {
        addWall(column, row);
      }
    }
  }
}

void FitField::addWall(int column, int row)
{
  const int left = std::max(0, column - reach_);
  const int right = std::min(columns_ - 1, column + reach_);
  for (int y = std::max(0, row - reach_); y <= std::min(rows_ - 1, row + reach_); ++y) {
    const std::uint8_t * kernel = &kernel_[static_cast<std::size_t>(y - row + reach_) * (2 * reach_ + 1)];
    std::uint8_t * values = &values_[static_cast<std::size_t>(y) * columns_];
    for (int x = left; x <= right; ++x) {
      values[x] = std::max(values[x], kernel[x - column + reach_]);
    }
  }
}

int FitField::valueAt(double x, double y) const
{
  const int column = static_cast<int>(std::floor(x * cells_per_metre_));
  const int row = static_cast<int>(std::floor(y * cells_per_metre_));
  const bool is_inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
  return is_inside ? values_[static_cast<std::size_t>(row) * columns_ + column] : 0;
}

double FitField::fit(const Points & points, const Pose2 & pose, double least) const
{
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  const double full = kFull * static_cast<double>(points.size());
  double allowed = (1.0 - least) * full;  // to miss
  for (const auto & point : points) {
    allowed -= kFull - valueAt(pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y);
    if (allowed < 0.0) {
      return 0.0;
    }
  }
  return least + allowed / full;
}
}  // namespace amcl
