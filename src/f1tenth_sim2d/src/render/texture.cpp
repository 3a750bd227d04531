#include "render/texture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace f1tenth_sim2d
{
namespace
{
/// Beyond it a texture coordinate, in 256ths of a texel, has lost all digits of a float anyway.
constexpr float kFarthest = 1e9F;

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

int roundedDown(float number)
{
  const float within = std::max(-kFarthest, std::min(number, kFarthest));
  const int truncated = static_cast<int>(within);
  return truncated - (static_cast<float>(truncated) > within ? 1 : 0);
}

/// Half the logarithm to base two, rounded to a whole number; 0 for what is below 1.
std::size_t halfLogarithm(float number)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  const int exponent = static_cast<int>(bits >> 23) - 127;
  return exponent > 0 ? static_cast<std::size_t>(exponent + 1) / 2 : 0;
}

/// Of two texels, each channel; weight is that of b, 0 to 256.
std::uint32_t blend(std::uint32_t a, std::uint32_t b, std::uint32_t weight)
{
  constexpr std::uint32_t kOuter = 0xff00ff;
  constexpr std::uint32_t kInner = 0x00ff00;
  const std::uint32_t outer = ((a & kOuter) * (256 - weight) + (b & kOuter) * weight) >> 8 & kOuter;
  const std::uint32_t inner = ((a & kInner) * (256 - weight) + (b & kInner) * weight) >> 8 & kInner;
  return outer | inner;
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

Colour Texture::at(float u, float v, std::size_t level) const
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
  const std::uint32_t texel = blend(upper, lower, static_cast<std::uint32_t>(y) & 0xff);
  constexpr float kScale = 1.0F / 255.0F;
  return {
    static_cast<float>(channel(texel, 0)) * kScale, static_cast<float>(channel(texel, 8)) * kScale,
    static_cast<float>(channel(texel, 16)) * kScale};
}
}  // namespace f1tenth_sim2d
