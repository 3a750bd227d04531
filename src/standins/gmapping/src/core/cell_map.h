#pragma once

#include <mrpt/containers/CDynamicGrid.h>

#include <cstdint>

#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"

namespace gmapping
{
/// What beams have told about a cell.
struct MapCell
{
  std::uint32_t visits{0};  ///< beams that crossed it or ended in it
  std::uint32_t hits{0};    ///< beams that ended in it
  // Sums of where they ended, from the corner of the cell: small numbers keep their digits.
  float sum_x{0.0F};  ///< m
  float sum_y{0.0F};  ///< m

  bool occupied(double threshold) const { return hits > threshold * visits; }
};

/// A map as a mapper needs it. It grows with what is put into it.
class CellMap
{
public:
  /// @param resolution  m per cell
  explicit CellMap(double resolution);

  Cell index(const Vec2 & point) const
  {
    return {
      static_cast<int>(std::floor((point.x - cells_.getXMin()) / resolution_)),
      static_cast<int>(std::floor((point.y - cells_.getYMin()) / resolution_))};
  }
  /// Nothing for a cell that is not on the map.
  const MapCell * cell(const Cell & index) const
  {
    // Negative indices become large ones.
    return cells_.cellByIndex(static_cast<unsigned>(index.x), static_cast<unsigned>(index.y));
  }
  /// Mean of where beams ended in a cell that has hits.
  Vec2 meanHit(const Cell & index, const MapCell & cell) const
  {
    return {
      cells_.getXMin() + index.x * resolution_ + cell.sum_x / cell.hits,
      cells_.getYMin() + index.y * resolution_ + cell.sum_y / cell.hits};
  }

  /// Makes room for everything within reach (m) of a place.
  /// @throws Error for more than kMostCells; the map stays as it was
  void grow(const Vec2 & centre, double reach);
  /// Counts a beam. Both ends have to be on the map.
  /// @param is_hit  whether the beam ended at something
  void addBeam(const Vec2 & from, const Vec2 & to, bool is_hit);

  /// @param options  extent and threshold; the grid is larger if the map is
  /// @throws Error for more than kMostCells
  OccupancyGrid grid(const SlamOptions & options) const;

private:
  MapCell & at(const Cell & index) { return *cells_.cellByIndex(index.x, index.y); }

  double resolution_;
  mrpt::containers::CDynamicGrid<MapCell> cells_;
};
}  // namespace gmapping
