#include "render/visibility.h"

#include <algorithm>

namespace f1tenth_sim2d
{
std::vector<Visibility::Border> Visibility::bordersOf(const Pinhole & camera, const Transform & pixels_from_world)
{
  const auto & [x, y, w] = pixels_from_world.rows;
  const Vec3 & offset = pixels_from_world.offset;
  std::vector<Border> borders{
    {x + w, offset.x + offset.z},
    {camera.width * w - x, camera.width * offset.z - offset.x},
    {y + w, offset.y + offset.z},
    {camera.height * w - y, camera.height * offset.z - offset.y},
    {w, offset.z - camera.near}};
  for (Border & border : borders) {
    const double scale = 1.0 / norm(border.inwards);
    border = {scale * border.inwards, scale * border.offset};
  }
  return borders;
}

void Visibility::draw(const Scene & scene, const Pinhole & camera, const Transform & pose)
{
  corners_.clear();
  triangles_.clear();
  raster_.clear(
    camera.width, camera.height, static_cast<float>(1.0 / camera.far), static_cast<float>(1.0 / camera.near));
  const Transform pixels_from_world = camera.pixelsFromWorld(pose);
  const std::vector<Border> borders = bordersOf(camera, pixels_from_world);
  for (const PlacedSurface & placed : scene.surfaces) {
    const SurfaceMesh & mesh = *placed.surface.mesh;
    const Vec3 middle = placed.pose(mesh.middle);
    const bool is_outside = std::any_of(borders.begin(), borders.end(), [&](const Border & border) {
      return dot(border.inwards, middle) + border.offset < -mesh.radius;
    });
    if (!is_outside) {
      drawSurface(placed, pixels_from_world);
    }
  }
}

void Visibility::drawSurface(const PlacedSurface & placed, const Transform & pixels_from_world)
{
  const SurfaceMesh & mesh = *placed.surface.mesh;
  const Transform pixels_from_surface = pixels_from_world * placed.pose;
  const std::size_t first = corners_.size();
  for (const Vec3 & corner : mesh.corners) {
    const Vec3 at = pixels_from_surface(corner);
    raster_.locate(corners_.emplace_back(RasterCorner{at.x, at.y, at.z}));
  }
  for (const std::array<std::uint32_t, 3> & each : mesh.triangles) {
    const auto index = static_cast<std::uint32_t>(triangles_.size());
    const auto & [a, b, c] = each;
    if (raster_.draw(corners_[first + a], corners_[first + b], corners_[first + c], !mesh.is_closed, index)) {
      triangles_.push_back({&placed, each, static_cast<std::uint32_t>(first)});
    }
  }
}

TriangleSetup Visibility::setupOf(const Triangle & triangle) const
{
  const auto corner = [&](std::size_t i) -> const RasterCorner & {
    return corners_[triangle.first_corner + triangle.corners[i]];
  };
  return {corner(0), corner(1), corner(2)};
}
}  // namespace f1tenth_sim2d
