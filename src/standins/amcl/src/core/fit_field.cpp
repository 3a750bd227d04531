#include "fit_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace amcl
{
namespace
{
constexpr float kWall = 0.3F;            // probability of being free: of cells that are walls at most,
constexpr float kFreeLeast = 0.7F;       // and of free ones at least
constexpr double kDistanceStep = 0.004;  // m, of distances
constexpr int kFar = 127;                // steps; what is farther away counts as this
constexpr int kFull = 255;               // stands for a fit of 1

}  // namespace

/// What walls are made of on a map.
class Walls
{
public:
  explicit Walls(const mrpt::maps::COccupancyGridMap2D & map) : map_(map) {}

  bool isSolid(int column, int row) const
  {
    // Unknown cells may be the inside of a wall, but beside free ones they are where a map is not sharp.
    const auto is_free = [this](int x, int y) { return map_.getCell(x, y) > kFreeLeast; };
    return isWall(column, row) || !anyAbout(column, row, is_free);
  }

  bool isBorder(int column, int row) const
  {
    if (isWall(column, row)) {
      return anyAbout(column, row, [this](int x, int y) { return !isSolid(x, y); });
    }
    return anyAbout(column, row, [this](int x, int y) { return isWall(x, y); }) && !isSolid(column, row);
  }

private:
  bool isWall(int column, int row) const { return map_.getCell(column, row) < kWall; }

  template <typename Predicate>
  static bool anyAbout(int column, int row, Predicate predicate)
  {
    for (int i = 0; i < 9; ++i) {
      if (predicate(column + i % 3 - 1, row + i / 3 - 1)) {
        return true;
      }
    }
    return false;
  }

  const mrpt::maps::COccupancyGridMap2D & map_;
};

Fit::Fit(double slack, double deviation)
{
  for (int i = 0; i < kFar; ++i) {
    const double away = std::max(0.0, i * kDistanceStep - slack) / deviation;
    values_[i] = static_cast<std::uint8_t>(std::lround(kFull * std::exp(-0.5 * away * away)));
  }
  values_[kFar] = 0;
}

FitField::FitField(const mrpt::maps::COccupancyGridMap2D & map)
: columns_(static_cast<int>(map.getSizeX())),
  rows_(static_cast<int>(map.getSizeY())),
  cells_per_metre_(1.0 / map.getResolution()),
  distances_(static_cast<std::size_t>(columns_) * rows_, kFar)
{
  const Walls walls(map);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (walls.isBorder(column, row)) {
        tellFrom(walls, column, row);
      }
    }
  }
}

/// Tells the cells beyond a border how far they are from it: half a cell less than from the cell on this side.
void FitField::tellFrom(const Walls & walls, int column, int row)
{
  const bool is_solid = walls.isSolid(column, row);
  const int reach = static_cast<int>(std::ceil(kFar * kDistanceStep * cells_per_metre_));
  for (int y = std::max(0, row - reach); y <= std::min(rows_ - 1, row + reach); ++y) {
    for (int x = std::max(0, column - reach); x <= std::min(columns_ - 1, column + reach); ++x) {
      const double cells = std::hypot(x - column, y - row) - 0.5;
      const long away = std::lround(cells / (cells_per_metre_ * kDistanceStep));
      if (away < std::abs(at(x, y)) && walls.isSolid(x, y) != is_solid) {
        at(x, y) = static_cast<std::int8_t>(is_solid ? away : -away);
      }
    }
  }
}

int FitField::distanceAt(double x, double y) const
{
  const double u = x * cells_per_metre_;
  const double v = y * cells_per_metre_;
  if (!(u >= 0.0 && v >= 0.0 && u < columns_ && v < rows_)) {
    return kFar;
  }
  return std::abs(at(static_cast<int>(u), static_cast<int>(v)));
}

int FitField::distanceBetween(double x, double y) const
{
  const double u = x * cells_per_metre_ - 0.5;
  const double v = y * cells_per_metre_ - 0.5;
  if (!(u >= 0.0 && v >= 0.0 && u < columns_ - 1 && v < rows_ - 1)) {
    return kFar;
  }
  const int column = static_cast<int>(u);
  const int row = static_cast<int>(v);
  const double right = u - column;
  const double below = (1.0 - right) * at(column, row) + right * at(column + 1, row);
  const double above = (1.0 - right) * at(column, row + 1) + right * at(column + 1, row + 1);
  const double up = v - row;
  return static_cast<int>(std::abs((1.0 - up) * below + up * above) + 0.5);  // faster than lround
}

template <typename Distance>
double FitField::mean(const Fit & fit, const Points & points, const Pose2 & pose, double least, Distance distance) const
{
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  const double full = kFull * static_cast<double>(points.size());
  double allowed = (1.0 - least) * full;  // to miss
  for (const auto & point : points) {
    allowed -= kFull - fit.at(distance(pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y));
    if (allowed < 0.0) {
      return 0.0;
    }
  }
  return least + allowed / full;
}

double FitField::rough(const Fit & fit, const Points & points, const Pose2 & pose, double least) const
{
  return mean(fit, points, pose, least, [this](double x, double y) { return distanceAt(x, y); });
}

double FitField::close(const Fit & fit, const Points & points, const Pose2 & pose, double least) const
{
  return mean(fit, points, pose, least, [this](double x, double y) { return distanceBetween(x, y); });
}
}  // namespace amcl
