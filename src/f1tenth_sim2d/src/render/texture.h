#pragma once

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

  /// @param u, v  to the right and upwards, 0 to 1 for the whole image
  Colour at(float u, float v, std::size_t level) const;

private:
  struct Level
  {
    std::uint32_t width;
    std::uint32_t height;
    std::vector<std::uint32_t> texels;  ///< red in the lowest byte
  };
  static Level halved(const Level & level);

  std::vector<Level> levels_;
};
}  // namespace f1tenth_sim2d
