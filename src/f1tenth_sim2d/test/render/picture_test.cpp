#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "small_scene.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr float kNothing = std::numeric_limits<float>::infinity();
const Pose3 kTilted(1.0, -2.0, 0.7, 0.1, 0.2, 0.6);

/// Distance along a ray to the nearest point of a ball; infinite if it is missed.
double alongRayToBall(const Vec3 & origin, const Vec3 & ray, const Vec3 & middle, double radius)
{
  const Vec3 away = origin - middle;
  const double a = dot(ray, ray);
  const double b = dot(away, ray);
  const double root = b * b - a * (dot(away, away) - radius * radius);
  return root < 0.0 ? std::numeric_limits<double>::infinity() : (-b - std::sqrt(root)) / a;
}

TEST(Picture, ShowsCornersWhereTheCameraProjectsThem)
{
  const Transform camera = toTransform(kTilted);
  for (const Vec3 & seen : {Vec3{3.0, 0.5, 0.3}, Vec3{6.0, -2.0, -1.0}, Vec3{2.0, -0.8, 0.9}}) {
    Scene scene;
    const Vec3 place = camera(seen);
    add(scene, meshOf(Box{Eigen::Vector3d::Constant(0.01 * seen.x)}, {}), Pose3(place.x, place.y, place.z, 0, 0, 0));
    const Picture picture = pictureOf(scene, kTilted);
    double columns = 0.0;
    double rows = 0.0;
    double count = 0.0;
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column) {
        if (depthAt(picture, column, row) < kNothing) {
          columns += column;
          rows += row;
          count += 1.0;
        }
      }
    }
    ASSERT_GT(count, 0.0);
    EXPECT_NEAR(columns / count, kCamera.middle_x - kCamera.focal_x * seen.y / seen.x, 0.5);
    EXPECT_NEAR(rows / count, kCamera.middle_y - kCamera.focal_y * seen.z / seen.x, 0.5);
  }
}

TEST(Picture, HasTheDepthsOfThePlaneAndOfBoxes)
{
  Scene scene;
  add(scene, rectangle(2000.0, 2000.0, {}), Pose3());
  add(scene, meshOf(Box{{1.0, 40.0, 9.0}}, {}), Pose3(9.5, 0, 0, 0, 0, 0));
  const Pose3 pose(1.0, -2.0, 0.7, 0.1, 0.2, 0.3);
  const Picture picture = pictureOf(scene, pose);
  const Transform camera = toTransform(pose);
  for (int row = 0; row < picture.height; row += 7) {
    for (int column = 0; column < picture.width; column += 5) {
      const Vec3 ray = camera.turned(kCamera.ray(column, row));
      const double to_floor = ray.z < 0.0 ? -0.7 / ray.z : std::numeric_limits<double>::infinity();
      const double to_wall = 8.0 / ray.x;
      const bool hits_wall = 0.7 + to_wall * ray.z < 4.5;
      if (to_floor < to_wall || hits_wall) {
        EXPECT_NEAR(depthAt(picture, column, row), std::min(to_floor, to_wall), 1e-4) << column << ", " << row;
      }
    }
  }
}

TEST(Picture, HasTheDepthsOfABall)
{
  Scene scene;
  add(scene, meshOf(Sphere{0.5}, {}), Pose3(3, 0, 0, 0, 0, 0));
  const Picture picture = pictureOf(scene, Pose3());
  int hits = 0;
  for (int row = 0; row < picture.height; row += 3) {
    for (int column = 0; column < picture.width; column += 3) {
      const Vec3 ray = kCamera.ray(column, row);
      if (alongRayToBall({}, ray, {3, 0, 0}, 0.4) < kNothing) {  // not where it is grazed
        EXPECT_NEAR(depthAt(picture, column, row), alongRayToBall({}, ray, {3, 0, 0}, 0.5), 0.01);
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(Picture, IsNotMirrored)
{
  Scene scene;
  add(scene, meshOf(Sphere{0.5}, {}), Pose3(4, 1.5, 1.0, 0, 0, 0));  // to the left and above
  const Picture picture = pictureOf(scene, Pose3());
  EXPECT_LT(depthAt(picture, 85, 70), kNothing);
  EXPECT_EQ(depthAt(picture, 235, 70), kNothing);
  EXPECT_EQ(depthAt(picture, 85, 170), kNothing);
}

TEST(Picture, HasShadowsOppositeTheSun)
{
  for (const bool moves : {false, true}) {
    Scene scene;
    add(scene, rectangle(100.0, 100.0, {}), Pose3());
    scene.surfaces[0].surface.casts_shadow = false;
    scene.light.to_sun = normalized({0.0, 1.0, 1.0});
    add(scene, meshOf(Sphere{0.3}, {}), Pose3(0, 0, 1.0, 0, 0, 0), {}, moves);
    const Picture picture = pictureOf(scene, Pose3(0, 0, 8.0, 0, M_PI / 2, 0));  // from above; y is to the left
    const int metre = 25;                                                        // pixels on the floor
    EXPECT_LT(3 * brightnessAt(picture, 160 + metre, 120), 2 * brightnessAt(picture, 160 - metre, 120));
    EXPECT_EQ(brightnessAt(picture, 160 - metre, 120), brightnessAt(picture, 160 + 3 * metre, 120));
  }
}

TEST(Picture, DoesNotShadeSurfacesByThemselves)
{
  Scene scene;
  add(scene, rectangle(30.0, 30.0, {}), Pose3());
  add(scene, meshOf(Box{{2, 2, 2}}, {}), Pose3(-5, 0, 1, 0, 0, 0.3));  // behind the camera, its shadow farther back
  Scene without = scene;
  for (PlacedSurface & placed : without.surfaces) {
    placed.surface.casts_shadow = false;
  }
  const Pose3 pose(0, 0, 3.0, 0, 0.3, 0);
  const Picture shaded = pictureOf(scene, pose);
  const Picture plain = pictureOf(without, pose);
  EXPECT_EQ(shaded.colours, plain.colours);
}

TEST(Picture, CanBeOfAnySize)
{
  Scene scene;
  add(scene, meshOf(Box{{1, 99, 99}}, {}), Pose3(3, 0, 0, 0, 0, 0));
  for (const auto & [width, height] : {std::pair{1, 1}, std::pair{1, 300}, std::pair{300, 1}, std::pair{4096, 3000}}) {
    const double focal = std::max(width, height);
    const Pinhole camera{width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)};
    const Picture picture = pictureOf(scene, Pose3(), camera);
    EXPECT_NEAR(depthAt(picture, 0, 0), 2.5, 1e-5);
    EXPECT_NEAR(depthAt(picture, width - 1, height - 1), 2.5, 1e-5);
  }
}

TEST(Picture, ShowsNothingButTheSkyOfAnEmptyScene)
{
  const Picture picture = pictureOf({}, Pose3());
  EXPECT_TRUE(std::all_of(picture.depths.begin(), picture.depths.end(), [](float depth) { return depth == kNothing; }));
  EXPECT_LT(picture.colours[0], picture.colours[2]);
}

TEST(Picture, KeepsInsidesOfOpenMeshesVisible)
{
  const auto sheet = [](bool is_closed) {
    SurfaceMesh mesh;
    mesh.corners = {{0, -9, -9}, {0, 9, -9}, {0, 0, 9}};
    mesh.triangles = {{0, 1, 2}};
    mesh.is_closed = is_closed;
    makeFlat(mesh);
    enclose(mesh);
    Scene scene;
    add(scene, std::make_shared<SurfaceMesh>(mesh), Pose3(2, 0, 0, 0, 0, 0));
    return scene;
  };
  EXPECT_EQ(depthAt(pictureOf(sheet(true), Pose3()), 160, 120), kNothing);
  EXPECT_FLOAT_EQ(depthAt(pictureOf(sheet(false), Pose3()), 160, 120), 2.0F);
}
}  // namespace
}  // namespace f1tenth_sim2d
