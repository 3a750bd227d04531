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
  /// Of all that never moves.
  static ShadowMap ofFixed(const Scene & scene);
  /// Of what moves, around a point.
  static ShadowMap ofMoving(const Scene & scene, const Vec3 & around);

  bool isEmpty() const { return raster_.width() == 0; }
  /// Coordinates of a point of the world in the map: column, row and height towards the sun (m).
  const Transform & mapFromWorld() const { return map_from_world_; }
  /// m, by which a point has to be lifted along its normal so that it does not shade itself.
  double lift() const { return lift_; }
  /// Share of the sun's light at a point of the map, 0 to 1.
  float light(float column, float row, float height) const;

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

  ShadowMap(const Scene & scene, const std::vector<const PlacedSurface *> & casters, const Window & window);

  Transform map_from_world_;
  double lift_{0.0};
  Raster raster_;
};
}  // namespace f1tenth_sim2d
