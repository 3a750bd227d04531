#pragma once

#include <memory>
#include <utility>

#include "render/renderer.h"
#include "render/solid_mesh.h"

namespace f1tenth_sim2d
{
constexpr Pinhole kCamera{320, 240, 200.0, 200.0, 159.5, 119.5, 0.02, 1000.0};

inline void add(
  Scene & scene, std::shared_ptr<const SurfaceMesh> mesh, const Pose3 & pose,
  const Colour & colour = {0.7F, 0.7F, 0.7F}, bool moves = false)
{
  PlacedSurface & placed = scene.surfaces.emplace_back();
  placed.surface.mesh = std::move(mesh);
  placed.surface.material.diffuse = colour;
  placed.pose = toTransform(pose);
  placed.moves = moves;
}

inline Picture pictureOf(const Scene & scene, const Pose3 & pose, const Pinhole & camera = kCamera)
{
  Picture picture;
  ShadowMap shadows;
  shadows.showFixed(scene);
  Renderer().draw(scene, shadows, camera, toTransform(pose), picture);
  return picture;
}

inline std::size_t indexOf(const Picture & picture, int column, int row)
{
  return static_cast<std::size_t>(row * picture.width + column);
}
inline float depthAt(const Picture & picture, int column, int row)
{
  return picture.depths[indexOf(picture, column, row)];
}
/// Sum of the three channels.
inline int brightnessAt(const Picture & picture, int column, int row)
{
  const std::size_t first = 3 * indexOf(picture, column, row);
  return picture.colours[first] + picture.colours[first + 1] + picture.colours[first + 2];
}
}  // namespace f1tenth_sim2d
