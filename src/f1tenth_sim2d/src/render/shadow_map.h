#pragma once

#include <algorithm>
#include <vector>

#include "render/raster.h"
#include "render/scene.h"

namespace f1tenth_sim2d
{
/// What the sun sees of some surfaces, so that it can be told what lies in their shadow.
class ShadowMap
{
public:
  /// Shows all that never moves.
  void showFixed(const Scene & scene);
  /// Shows what moves, around a point.
  void showMoving(const Scene & scene, const Vec3 & around);

  bool isEmpty() const { return is_empty_; }
  /// Coordinates of a point of the world in the map: column, row and height towards the sun (m).
  const Transform & mapFromWorld() const { return map_from_world_; }
  /// m, by which a point has to be lifted along its normal so that it does not shade itself.
  double lift() const { return lift_; }
  /// Whether nothing between two points of the map is in a shadow.
  bool isLit(float column, float row, float other_column, float other_row) const
  {
    constexpr float kMargin = 1.0F;  // texels: the points between are rounded, too
    return std::max(column, other_column) < first_column_ - kMargin ||
           std::min(column, other_column) > last_column_ + kMargin || std::max(row, other_row) < first_row_ - kMargin ||
           std::min(row, other_row) > last_row_ + kMargin;
  }
  /// Share of the sun's light at a point of the map, 0 to 1.
  float light(float column, float row, float height) const
  {
    const bool is_inside = column >= first_column_ && row >= first_row_ && column < last_column_ && row < last_row_;
    if (!is_inside) {
      return 1.0F;
    }
    const int left = static_cast<int>(column);
    const int top = static_cast<int>(row);
    if (highest(top)[left] <= height) {
      return 1.0F;
    }
    const float * const upper = raster_.nearness(top) + left;
    const float * const lower = raster_.nearness(top + 1) + left;
    const auto lit = [height](float nearest) { return nearest <= height ? 1.0F : 0.0F; };
    const float right_share = column - static_cast<float>(left);
    const float lower_share = row - static_cast<float>(top);
    const float above = lit(upper[0]) + (lit(upper[1]) - lit(upper[0])) * right_share;
    const float below = lit(lower[0]) + (lit(lower[1]) - lit(lower[0])) * right_share;
    return above + (below - above) * lower_share;
  }

private:
  /// A rectangle across the sun's light.
  struct Window
  {
    double left;   ///< m
    double top;    ///< m
    double texel;  ///< m
    int columns;
    int rows;
  };

  const float * highest(int row) const
  {
    return &highest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster_.width())];
  }
  void findHighest();
  void show(const Scene & scene, const std::vector<const PlacedSurface *> & casters, const Window & window);

  bool is_empty_{true};
  Transform map_from_world_;
  double lift_{0.0};
  // All shadows are in between.
  float first_column_{0.0F};
  float first_row_{0.0F};
  float last_column_{0.0F};
  float last_row_{0.0F};
  Raster raster_;
  std::vector<float> highest_;  ///< of each pixel, the next one and those below
};
}  // namespace f1tenth_sim2d
