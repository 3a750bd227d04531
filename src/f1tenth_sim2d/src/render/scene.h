#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/linear.h"
#include "render/texture.h"

/// What cameras see: plain data.
namespace f1tenth_sim2d
{
/// Triangles that are drawn; counter-clockwise seen from outside.
struct SurfaceMesh
{
  std::vector<Vec3> corners;                         ///< m
  std::vector<Vec3> normals;                         ///< one per corner, unit
  std::vector<std::array<float, 2>> texture_points;  ///< one per corner, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool is_closed{false};  ///< its inside is never seen
  Vec3 middle;            ///< of the ball around it, m
  double radius{0.0};     ///< of that ball, m
};

/// Fills in the ball around a mesh.
void enclose(SurfaceMesh & mesh);

struct Material
{
  Colour diffuse{0.7F, 0.7F, 0.7F};
  Colour emission;
  std::shared_ptr<const Texture> texture;  ///< null: none; multiplied with diffuse
};

struct Surface
{
  std::shared_ptr<const SurfaceMesh> mesh;
  Material material;
  bool casts_shadow{true};
};

/// What is seen of one thing, in its own frame.
struct Appearance
{
  std::vector<Surface> surfaces;
  std::string warning;  ///< what is not drawn as described, with its place; empty: nothing
};

/// A surface where it is drawn.
struct PlacedSurface
{
  Surface surface;
  Transform pose;  ///< in the world
  bool moves{false};
};

struct Light
{
  Vec3 to_sun{0.484, -0.097, 0.870};         ///< unit, in the world
  Colour sun{0.75F, 0.75F, 0.72F};           ///< on a surface that faces it
  Colour surroundings{0.52F, 0.53F, 0.56F};  ///< from everywhere
  Colour zenith{0.36F, 0.56F, 0.83F};
  Colour horizon{0.80F, 0.86F, 0.92F};
};

struct Scene
{
  std::vector<PlacedSurface> surfaces;
  Light light;
};
}  // namespace f1tenth_sim2d
