#pragma once

#include <array>
#include <vector>

#include "move_base/map/geometry.h"

namespace move_base
{
struct Disc
{
  Vec2 centre;         ///< m
  double radius{0.0};  ///< m
};

/// The car's outline in its base frame (below the rear axle), and discs that cover it: large ones along its axis, small
/// ones at its ends. They stick out by up to 4 cm at the ends and 2 cm at the sides.
class Footprint
{
public:
  /// @param corners  of the outline in the base frame, m, any order of turning
  /// @param padding  m, added on every side
  /// @throws OptionError for fewer than three corners or an outline without an area
  explicit Footprint(std::vector<Vec2> corners, double padding = 0.0);

  const std::vector<Vec2> & corners() const { return corners_; }
  static constexpr std::size_t kDiscs = 7;
  const std::array<Disc, kDiscs> & discs() const { return discs_; }
  /// Distance from the base frame to the nearest edge, m.
  double inscribedRadius() const { return inscribed_radius_; }
  /// Half of the width, m.
  double halfWidth() const { return half_width_; }
  /// Where the outline ends along the car's axis, m ahead of the base frame; the rear end is behind it.
  double rear() const { return rear_; }
  double front() const { return front_; }
  /// A disc around all the others.
  const Disc & around() const { return around_; }

private:
  void coverWithDiscs();

  std::vector<Vec2> corners_;
  std::array<Disc, kDiscs> discs_;
  double inscribed_radius_{0.0};
  double half_width_{0.0};
  double rear_{0.0};
  double front_{0.0};
  Disc around_;
};

/// 0.58 m x 0.31 m, the rear axle 0.125 m ahead of the rear end.
std::vector<Vec2> defaultFootprint();
}  // namespace move_base
