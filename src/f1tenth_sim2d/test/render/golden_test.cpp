#include <gtest/gtest.h>

#include <cstring>

#include "render/lens.h"
#include "small_scene.h"

/// Compiled with several sets of options: each has to give the same bits.
namespace f1tenth_sim2d
{
namespace
{
constexpr std::uint32_t kColours = 2854086569;
constexpr std::uint32_t kDepths = 229528681;
constexpr std::uint32_t kBentColours = 2419257105;
constexpr std::uint32_t kBentDepths = 2993445971;

/// FNV-1a.
std::uint32_t hashOf(const void * data, std::size_t size)
{
  const auto * const bytes = static_cast<const std::uint8_t *>(data);
  std::uint32_t hash = 2166136261U;
  for (std::size_t i = 0; i < size; ++i) {
    hash = (hash ^ bytes[i]) * 16777619U;
  }
  return hash;
}

Scene everything()
{
  Scene scene;
  add(scene, rectangle(2000.0, 2000.0, {0.7}), Pose3());
  Image image{8, 8, {}};
  for (std::uint32_t i = 0; i < 8 * 8 * 3; ++i) {
    image.bytes.push_back(static_cast<std::uint8_t>(hashOf(&i, sizeof(i))));
  }
  scene.surfaces[0].surface.material.texture = std::make_shared<Texture>(image);
  add(scene, meshOf(Box{{1, 1, 1}}, {}), Pose3(4, 1, 0.5, 0.1, 0.2, 0.5), {0.8F, 0.3F, 0.2F});
  add(scene, meshOf(Cylinder{0.3, 1}, {}), Pose3(3, -1, 0.5, 0, 0, 0.2), {0.2F, 0.8F, 0.3F}, true);
  add(scene, meshOf(Sphere{0.4}, {}), Pose3(3, 0, 0.4, 0, 0, 0), {0.9F, 0.8F, 0.2F}, true);
  add(scene, meshOf(Capsule{0.2, 0.5}, {}), Pose3(2.5, 0.8, 0.2, 1.5, 0, 0.8), {0.3F, 0.3F, 0.9F});
  add(scene, meshOf(Ellipsoid{{0.2, 0.5, 0.3}}, {}), Pose3(2.2, -0.5, 0.3, 0, 0, 0.8), {0.6F, 0.3F, 0.9F});
  return scene;
}

TEST(Golden, PicturesHaveTheSameBitsEverywhere)
{
  Picture picture = pictureOf(everything(), Pose3(0, 0, 0.6, 0.02, 0.1, 0.05));
  EXPECT_EQ(hashOf(picture.colours.data(), picture.colours.size()), kColours);
  EXPECT_EQ(hashOf(picture.depths.data(), picture.depths.size() * sizeof(float)), kDepths);
  Lens(kCamera, {-0.2, 0.02, 0.002, -0.003, 0.001}, true).bend(picture);
  EXPECT_EQ(hashOf(picture.colours.data(), picture.colours.size()), kBentColours);
  EXPECT_EQ(hashOf(picture.depths.data(), picture.depths.size() * sizeof(float)), kBentDepths);
}
}  // namespace
}  // namespace f1tenth_sim2d
