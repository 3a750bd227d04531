#pragma once

#include <vector>

#include "render/camera.h"
#include "render/shadow_map.h"
#include "render/visibility.h"

namespace f1tenth_sim2d
{
/// Gives the pixels of a picture their colours and depths.
class Shading
{
public:
  /// @param shadows  the maps of all that casts them; all of these must outlive this
  Shading(
    const Visibility & seen, const Light & light, const std::vector<const ShadowMap *> & shadows,
    const Pinhole & camera, const Transform & pose);

  /// Fills in one row of the picture.
  void shadeRow(int row, Picture & picture) const;

private:
  /// Where the rays of a row are in a shadow map, one metre along the axis: linear over the row.
  struct MapRay
  {
    const ShadowMap * map;
    Vec3 start;
    Vec3 step;
  };
  /// Pixels side by side that show one triangle.
  struct Run
  {
    int first;
    int end;
    int row;
  };

  std::vector<MapRay> mapRays(int row) const;
  void shadeSky(const Run & run, std::uint8_t * colours) const;
  void shadeRun(
    const Run & run, std::uint32_t triangle, const std::vector<MapRay> & rays, std::uint8_t * colours,
    const float * depths) const;

  const Visibility & seen_;
  const Light & light_;
  const std::vector<const ShadowMap *> & shadows_;
  const Pinhole & camera_;
  const Transform & pose_;
};
}  // namespace f1tenth_sim2d
