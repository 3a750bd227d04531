#pragma once

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
  /// Share of the sun's light at a point of the map, 0 to 1.
  float light(float column, float row, float height) const
  {
    const bool is_inside = column >= 0.0F && row >= 0.0F && column < static_cast<float>(raster_.width() - 1) &&
                           row < static_cast<float>(raster_.height() - 1);
    if (!is_inside) {
      return 1.0F;
    }
    const int left = static_cast<int>(column);
    const int top = static_cast<int>(row);
    const float right_share = column - static_cast<float>(left);
    const float lower_share = row - static_cast<float>(top);
    const auto lit = [height](float nearest) { return nearest <= height ? 1.0F : 0.0F; };
    const float * const upper = raster_.nearness(top) + left;
    const float * const lower = raster_.nearness(top + 1) + left;
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

  void show(const Scene & scene, const std::vector<const PlacedSurface *> & casters, const Window & window);

  bool is_empty_{true};
  Transform map_from_world_;
  double lift_{0.0};
  Raster raster_;
};
}  // namespace f1tenth_sim2d
