#pragma once

#include <memory>

#include "f1tenth_sim2d/world_model.h"
#include "render/scene.h"

namespace f1tenth_sim2d
{
/// How texture coordinates lie on a shape.
struct TextureScale
{
  /// m, for the whole texture; 0: it covers each face once, as in Gazebo.
  double tile{0.0};
};

/// What is seen of a shape.
std::shared_ptr<const SurfaceMesh> meshOf(const Box & box, const TextureScale & scale);
std::shared_ptr<const SurfaceMesh> meshOf(const Cylinder & cylinder, const TextureScale & scale);
std::shared_ptr<const SurfaceMesh> meshOf(const Sphere & sphere, const TextureScale & scale);
std::shared_ptr<const SurfaceMesh> meshOf(const Capsule & capsule, const TextureScale & scale);
std::shared_ptr<const SurfaceMesh> meshOf(const Ellipsoid & ellipsoid, const TextureScale & scale);
std::shared_ptr<const SurfaceMesh> meshOf(const Polyline & polyline, const TextureScale & scale);

/// A rectangle in the plane z = 0, seen from above, that is turned then.
/// @param width, depth  m, along x and y
std::shared_ptr<const SurfaceMesh> rectangle(
  double width, double depth, const TextureScale & scale, const Transform & turn = {});

/// The normals of a mesh that has none: those of its triangles, each of which gets corners of its own.
void makeFlat(SurfaceMesh & mesh);
}  // namespace f1tenth_sim2d
