#pragma once

#include <cstdint>
#include <vector>

#include "render/camera.h"
#include "render/raster.h"
#include "render/scene.h"

namespace f1tenth_sim2d
{
/// Which triangle each pixel of a camera shows.
class Visibility
{
public:
  struct Triangle
  {
    const PlacedSurface * placed;
    std::array<std::uint32_t, 3> corners;  ///< of the mesh
    std::uint32_t first_corner;            ///< of the mesh among the corners in the image
  };

  /// @param pose  of the camera in the world
  void draw(const Scene & scene, const Pinhole & camera, const Transform & pose);

  const Raster & raster() const { return raster_; }
  const Triangle & triangle(std::uint32_t index) const { return triangles_[index]; }
  TriangleSetup setupOf(const Triangle & triangle) const;

private:
  struct Border
  {
    Vec3 inwards;
    double offset;
  };

  static std::vector<Border> bordersOf(const Pinhole & camera, const Transform & pixels_from_world);
  void drawSurface(const PlacedSurface & placed, const Transform & pixels_from_world);

  Raster raster_;
  std::vector<RasterCorner> corners_;
  std::vector<Triangle> triangles_;
};
}  // namespace f1tenth_sim2d
