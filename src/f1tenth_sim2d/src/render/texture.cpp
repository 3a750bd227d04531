#include "render/texture.h"

#include <algorithm>
#include <cstring>

namespace f1tenth_sim2d
{
namespace
{
std::uint32_t powerOfTwo(std::size_t side)
{
  std::uint32_t power = 1;
  while (power < side && power < Texture::kSideMax) {
    power *= 2;
  }
  return power;
}

std::uint32_t packedTexel(unsigned red, unsigned green, unsigned blue)
{
  return red | green << 8 | blue << 16;
}

unsigned channel(std::uint32_t texel, unsigned shift)
{
  return texel >> shift & 0xff;
}

/// Mean of the pixels that a texel covers, at least of one.
std::uint32_t meanOf(const Image & image, std::size_t left, std::size_t right, std::size_t top, std::size_t bottom)
{
  std::array<std::size_t, 3> sum{};
  std::size_t count = 0;
  for (std::size_t row = top; row < std::max(bottom, top + 1); ++row) {
    for (std::size_t column = left; column < std::max(right, left + 1); ++column, ++count) {
      for (std::size_t i = 0; i < 3; ++i) {
        sum[i] += image.bytes[(row * image.width + column) * 3 + i];
      }
    }
  }
  const auto mean = [&](std::size_t i) { return static_cast<unsigned>((sum[i] + count / 2) / count); };
  return packedTexel(mean(0), mean(1), mean(2));
}

/// Half the logarithm to base two, rounded to a whole number; 0 for what is below 1.
std::size_t halfLogarithm(float number)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  const int exponent = static_cast<int>(bits >> 23) - 127;
  return exponent > 0 ? static_cast<std::size_t>(exponent + 1) / 2 : 0;
}
}  // namespace

Texture::Texture(const Image & image)
{
  Level & first = levels_.emplace_back();
  first.width = powerOfTwo(image.width);
  first.height = powerOfTwo(image.height);
  for (std::size_t row = 0; row < first.height; ++row) {
    for (std::size_t column = 0; column < first.width; ++column) {
      first.texels.push_back(meanOf(
        image, column * image.width / first.width, (column + 1) * image.width / first.width,
        row * image.height / first.height, (row + 1) * image.height / first.height));
    }
  }
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    levels_.push_back(halved(levels_.back()));
  }
}

Texture::Level Texture::halved(const Level & level)
{
  Level half{std::max(1U, level.width / 2), std::max(1U, level.height / 2), {}};
  for (std::uint32_t row = 0; row < half.height; ++row) {
    for (std::uint32_t column = 0; column < half.width; ++column) {
      const auto texel = [&](std::uint32_t right, std::uint32_t down) {
        const std::uint32_t x = std::min(2 * column + right, level.width - 1);
        return level.texels[std::min(2 * row + down, level.height - 1) * level.width + x];
      };
      const std::array<std::uint32_t, 4> four{texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)};
      const auto mean = [&](unsigned shift) {
        unsigned sum = 2;
        for (const std::uint32_t each : four) {
          sum += channel(each, shift);
        }
        return sum / 4;
      };
      half.texels.push_back(packedTexel(mean(0), mean(8), mean(16)));
    }
  }
  return half;
}

std::size_t Texture::levelFor(const std::array<float, 2> & across, const std::array<float, 2> & down) const
{
  const auto square = [&](const std::array<float, 2> & side) {
    const float u = side[0] * static_cast<float>(levels_[0].width);
    const float v = side[1] * static_cast<float>(levels_[0].height);
    return u * u + v * v;
  };
  // Seen from the side the longer one alone would blur what the shorter one resolves: half of it has to do.
  const float a = square(across);
  const float b = square(down);
  const float wanted = std::max(std::min(a, b), std::max(a, b) / 4.0F);
  return std::min(levels_.size() - 1, halfLogarithm(wanted));
}
}  // namespace f1tenth_sim2d
