#include "render/texture.h"

#include <gtest/gtest.h>

namespace f1tenth_sim2d
{
namespace
{
/// Left half black, right half white; the lower half of it red instead of white.
Image quarters(std::size_t side)
{
  Image image{side, side, {}};
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::uint8_t red = column < side / 2 ? 0 : 255;
      const std::uint8_t other = row < side / 2 ? red : 0;
      image.bytes.insert(image.bytes.end(), {red, other, other});
    }
  }
  return image;
}

Colour colourAt(const Texture & texture, float u, float v, std::size_t level)
{
  const std::uint32_t texel = texture.texelAt(u, v, level);
  const auto channel = [texel](unsigned shift) { return static_cast<float>(texel >> shift & 0xff) / 255.0F; };
  return {channel(0), channel(8), channel(16)};
}

TEST(Texture, HasItsOriginAtTheLowerLeft)
{
  const Texture texture(quarters(8));
  EXPECT_FLOAT_EQ(colourAt(texture, 0.25F, 0.75F, 0).red, 0.0F);
  EXPECT_FLOAT_EQ(colourAt(texture, 0.75F, 0.75F, 0).green, 1.0F);
  EXPECT_FLOAT_EQ(colourAt(texture, 0.75F, 0.25F, 0).red, 1.0F);
  EXPECT_FLOAT_EQ(colourAt(texture, 0.75F, 0.25F, 0).green, 0.0F);
}

TEST(Texture, RepeatsItselfOnBothSides)
{
  const Texture texture(quarters(8));
  for (const float turn : {-3.0F, -1.0F, 1.0F, 12.0F}) {
    EXPECT_FLOAT_EQ(colourAt(texture, 0.75F + turn, 0.25F, 0).red, 1.0F);
    EXPECT_FLOAT_EQ(colourAt(texture, 0.25F, 0.75F + turn, 0).red, 0.0F);
  }
}

TEST(Texture, BlendsNeighbours)
{
  const Texture texture(quarters(8));
  EXPECT_NEAR(colourAt(texture, 0.5F, 0.75F, 0).red, 0.5F, 0.01F);
}

TEST(Texture, TakesTheVersionWhoseTexelsAreAsLargeAsPixels)
{
  const Texture texture(quarters(64));
  const auto level = [&](float texels) { return texture.levelFor({texels / 64, 0}, {0, texels / 64}); };
  EXPECT_EQ(level(0.1F), 0U);
  EXPECT_EQ(level(1.0F), 0U);
  EXPECT_EQ(level(2.0F), 1U);
  EXPECT_EQ(level(8.0F), 3U);
  EXPECT_EQ(level(1e9F), 6U);
  EXPECT_NEAR(colourAt(texture, 0.3F, 0.3F, 6).red, 0.5F, 0.01F);
}

TEST(Texture, TakesImagesOfAnySize)
{
  for (const std::size_t side : {1U, 3U, 100U, 5000U}) {
    const Texture texture(Image{side, 1, std::vector<std::uint8_t>(3 * side, 200)});
    EXPECT_FLOAT_EQ(colourAt(texture, 0.3F, 0.9F, 0).blue, 200.0F / 255.0F);
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
