#include "render/solid_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
double volumeOf(const SurfaceMesh & mesh)
{
  double volume = 0.0;
  for (const auto & [a, b, c] : mesh.triangles) {
    volume += dot(mesh.corners[a], cross(mesh.corners[b], mesh.corners[c])) / 6.0;
  }
  return volume;
}

void expectOutwardNormals(const SurfaceMesh & mesh)
{
  for (const auto & triangle : mesh.triangles) {
    const auto & [a, b, c] = triangle;
    const Vec3 flat = cross(mesh.corners[b] - mesh.corners[a], mesh.corners[c] - mesh.corners[a]);
    for (const std::uint32_t corner : triangle) {
      EXPECT_NEAR(norm(mesh.normals[corner]), 1.0, 1e-12);
      EXPECT_GE(dot(mesh.normals[corner], flat), 0.0);
    }
  }
}

TEST(SolidMesh, EnclosesTheVolumeOfItsShape)
{
  const double pi = std::acos(-1.0);
  const std::vector<std::pair<std::shared_ptr<const SurfaceMesh>, double>> bodies{
    {meshOf(Box{{2, 3, 0.5}}, {}), 3.0},
    {meshOf(Cylinder{0.5, 2.0}, {}), pi * 0.5},
    {meshOf(Sphere{0.5}, {}), pi / 6.0},
    {meshOf(Capsule{0.5, 1.0}, {}), pi / 6.0 + pi / 4.0},
    {meshOf(Ellipsoid{{0.5, 1.0, 2.0}}, {}), 4.0 / 3.0 * pi},
    {meshOf(Polyline{{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, 1.5}, {}), 3.0},
  };
  for (const auto & [mesh, volume] : bodies) {
    EXPECT_NEAR(volumeOf(*mesh), volume, 0.02 * volume);
    expectOutwardNormals(*mesh);
    EXPECT_EQ(mesh->texture_points.size(), mesh->corners.size());
  }
}

TEST(SolidMesh, TilesATextureInMetres)
{
  const auto once = meshOf(Box{{2, 3, 0.5}}, {});
  const auto tiled = meshOf(Box{{2, 3, 0.5}}, {0.5});
  EXPECT_FLOAT_EQ(once->texture_points[2][0], 1.0F);
  EXPECT_FLOAT_EQ(tiled->texture_points[2][0], 4.0F);
  EXPECT_FLOAT_EQ(tiled->texture_points[2][1], 1.0F);
}

TEST(SolidMesh, GivesTrianglesTheirOwnNormals)
{
  SurfaceMesh mesh;
  mesh.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
  makeFlat(mesh);
  ASSERT_EQ(mesh.normals.size(), 6U);
  EXPECT_EQ(mesh.normals[mesh.triangles[0][1]].z, 1.0);
  EXPECT_EQ(mesh.normals[mesh.triangles[1][1]].y, 1.0);
}
}  // namespace
}  // namespace f1tenth_sim2d
