#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace f1tenth_sim2d
{
/// Red, green and blue, 0 to 1.
struct Colour
{
  float red{0.0F};
  float green{0.0F};
  float blue{0.0F};
};

/// Pixels of three bytes, red, green and blue; the top row first.
struct Image
{
  std::size_t width{0};
  std::size_t height{0};
  std::vector<std::uint8_t> bytes;
};

/// An image that repeats itself in both directions, with all its smaller versions.
class Texture
{
public:
  /// Larger images are made smaller.
  static constexpr std::size_t kSideMax = 2048;

  /// @param image  of at least one pixel; brought to powers of two
  explicit Texture(const Image & image);

  /// The version to be looked up where one pixel covers a parallelogram of the texture.
  /// @param across, down  its sides: the change of the texture coordinates from one pixel to the next
  std::size_t levelFor(const std::array<float, 2> & across, const std::array<float, 2> & down) const;

  /// Red in the lowest byte, then green and blue.
  /// @param u, v  to the right and upwards, 0 to 1 for the whole image
  std::uint32_t texelAt(float u, float v, std::size_t level) const
  {
    const Level & image = levels_[level];
    const int x = roundedDown(u * static_cast<float>(image.width * 256)) - 128;
    const int y = roundedDown((1.0F - v) * static_cast<float>(image.height * 256)) - 128;
    const auto left = static_cast<std::uint32_t>(x >> 8) & (image.width - 1);
    const auto right = (left + 1) & (image.width - 1);
    const std::uint32_t top = (static_cast<std::uint32_t>(y >> 8) & (image.height - 1)) * image.width;
    const std::uint32_t bottom = (static_cast<std::uint32_t>((y >> 8) + 1) & (image.height - 1)) * image.width;
    const std::uint32_t weight = static_cast<std::uint32_t>(x) & 0xff;
    const std::uint32_t upper = blend(image.texels[top + left], image.texels[top + right], weight);
    const std::uint32_t lower = blend(image.texels[bottom + left], image.texels[bottom + right], weight);
    return blend(upper, lower, static_cast<std::uint32_t>(y) & 0xff);
  }

private:
  struct Level
  {
    std::uint32_t width;
    std::uint32_t height;
    std::vector<std::uint32_t> texels;  ///< red in the lowest byte
  };
  static Level halved(const Level & level);

  static int roundedDown(float number)
  {
    // Beyond it a coordinate, in 256ths of a texel, has lost all its digits anyway.
    constexpr float kLargest = 1e9F;
    const float within = std::max(-kLargest, std::min(number, kLargest));
    const int truncated = static_cast<int>(within);
    return truncated - (static_cast<float>(truncated) > within ? 1 : 0);
  }

  /// Of two texels, each channel; weight is that of b, 0 to 256.
  static std::uint32_t blend(std::uint32_t a, std::uint32_t b, std::uint32_t weight)
  {
    constexpr std::uint32_t kOuter = 0xff00ff;
    constexpr std::uint32_t kInner = 0x00ff00;
    const std::uint32_t outer = ((a & kOuter) * (256 - weight) + (b & kOuter) * weight) >> 8 & kOuter;
    const std::uint32_t inner = ((a & kInner) * (256 - weight) + (b & kInner) * weight) >> 8 & kInner;
    return outer | inner;
  }

  std::vector<Level> levels_;
};
}  // namespace f1tenth_sim2d
