#pragma once

#include <vector>

#include "move_base/geometry.h"

namespace move_base
{
/// The car's outline in its base frame (below the rear axle), covered by discs of one radius along its length.
class Footprint
{
public:
  /// @param corners  of the outline in the base frame, m, any order of turning
  /// @param padding  m, added on every side
  /// @throws OptionError for fewer than three corners or an outline without an area
  explicit Footprint(std::vector<Vec2> corners, double padding = 0.0);

  const std::vector<Vec2> & corners() const { return corners_; }
  /// Centres of the discs along the base frame's x axis; the lateral offset of all is the same.
  const std::vector<Vec2> & discs() const { return discs_; }
  double discRadius() const { return disc_radius_; }

private:
  void coverWithDiscs();

  std::vector<Vec2> corners_;
  std::vector<Vec2> discs_;
  double disc_radius_{0.0};
};

/// 0.58 m x 0.31 m, the rear axle 0.125 m before the rear end.
std::vector<Vec2> defaultFootprint();
}  // namespace move_base
