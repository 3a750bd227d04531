#include "render/lens.h"

#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr Distortion kBarrel{-0.2, 0.02, 0.002, -0.003, 0.001};

Picture wallBehind(const Lens & lens)
{
  Scene scene;
  add(scene, meshOf(Box{{1, 100, 100}}, {}), Pose3(3.5, 0, 0, 0, 0, 0));
  Picture picture = pictureOf(scene, Pose3(), lens.straight());
  lens.bend(picture);
  return picture;
}
}  // namespace

TEST(Lens, ShowsEachPixelWhereBrownsModelPutsIt)
{
  const Lens lens(kCamera, kBarrel, false);
  for (const auto & [column, row] : {std::pair{160, 120}, {60, 40}, {250, 200}, {20, 120}}) {
    const Vec3 ray = lens.ray(static_cast<std::size_t>(row * kCamera.width + column));
    const double x = -ray.y;
    const double y = -ray.z;
    const double r2 = x * x + y * y;
    const double radial = 1.0 - 0.2 * r2 + 0.02 * r2 * r2 + 0.001 * r2 * r2 * r2;
    const double bent_x = x * radial + 2.0 * 0.002 * x * y - 0.003 * (r2 + 2.0 * x * x);
    const double bent_y = y * radial + 0.002 * (r2 + 2.0 * y * y) - 2.0 * 0.003 * x * y;
    EXPECT_NEAR(kCamera.middle_x + kCamera.focal_x * bent_x, column, 1e-3);
    EXPECT_NEAR(kCamera.middle_y + kCamera.focal_y * bent_y, row, 1e-3);
  }
}

TEST(Lens, LeavesABlackBorderUnlessItCrops)
{
  const Picture whole = wallBehind(Lens(kCamera, kBarrel, false));
  EXPECT_EQ(brightnessAt(whole, 0, 0), 0);
  EXPECT_TRUE(std::isinf(depthAt(whole, 0, 0)));
  EXPECT_NEAR(depthAt(whole, 160, 120), 3.0, 1e-5);

  const Lens cropping(kCamera, kBarrel, true);
  EXPECT_GT(cropping.bent().focal_x, kCamera.focal_x);
  for (const float depth : wallBehind(cropping).depths) {
    ASSERT_NEAR(depth, 3.0, 1e-4);
  }
}

TEST(Lens, KeepsTheDepthsOfASlope)
{
  Scene scene;
  add(scene, rectangle(2000.0, 2000.0, {0.7}), Pose3());
  const Lens lens(kCamera, kBarrel, true);
  Picture picture = pictureOf(scene, Pose3(0, 0, 0.5, 0, 0, 0), lens.straight());
  lens.bend(picture);
  for (int row = 160; row < kCamera.height; row += 10) {
    const Vec3 ray = lens.ray(indexOf(picture, 100, row));
    EXPECT_NEAR(depthAt(picture, 100, row), -0.5 / ray.z, 0.01) << row;
  }
}

TEST(Lens, IsBlackWhereItWouldFoldThePictureOver)
{
  const Picture picture = wallBehind(Lens(kCamera, {-3.0, 0.0, 0.0, 0.0, 0.0}, false));
  EXPECT_NEAR(depthAt(picture, 160, 120), 3.0, 1e-5);
  EXPECT_TRUE(std::isinf(depthAt(picture, 0, 120)));
  const Picture absurd = wallBehind(Lens(kCamera, {1e4, -1e4, 1e4, -1e4, 1e4}, true));
  EXPECT_EQ(absurd.depths.size(), static_cast<std::size_t>(kCamera.width * kCamera.height));
}
}  // namespace f1tenth_sim2d
