#include "loaders/visuals/patterns.h"

#include <workspace_support/maths/random.h>

#include <array>

namespace f1tenth_sim2d
{
namespace
{
constexpr unsigned kSide = 256;  // pixels

/// 0 to range - 1, at random.
unsigned randomAt(unsigned x, unsigned y, unsigned range)
{
  return static_cast<unsigned>(workspace_support::maths::mixBits(std::uint64_t{x} << 32 | y) % range);
}

/// Rectangles with joints between them, every second row shifted by half of one.
/// @param shift  of every second row, pixels
unsigned laid(unsigned x, unsigned y, unsigned width, unsigned height, unsigned shift, unsigned joint)
{
  const unsigned row = y / height;
  const unsigned along = (x + row % 2 * shift) % kSide;
  if (along % width < joint || y % height < joint) {
    return 150;
  }
  return 205 + randomAt(along / width + 100, row, 35) + randomAt(x, y, 15);
}

unsigned greyOf(Pattern pattern, unsigned x, unsigned y)
{
  switch (pattern) {
    case Pattern::kBricks:
      return laid(x, y, 64, 32, 32, 3);
    case Pattern::kPlanks:
      return laid(x, y, 256, 32, 112, 1) - randomAt(0, y, 25);
    case Pattern::kTiles:
      return laid(x, y, 128, 128, 0, 4);
    default:
      return 200 + randomAt(x / 4 + 1000, y / 4, 40) + randomAt(x, y, 15);
  }
}

std::shared_ptr<const Texture> drawn(Pattern pattern)
{
  Image image{kSide, kSide, {}};
  for (unsigned y = 0; y < kSide; ++y) {
    for (unsigned x = 0; x < kSide; ++x) {
      image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(greyOf(pattern, x, y)));
    }
  }
  return std::make_shared<Texture>(image);
}
}  // namespace

std::shared_ptr<const Texture> textureOf(Pattern pattern)
{
  static const std::array<std::shared_ptr<const Texture>, 5> kTextures{
    nullptr, drawn(Pattern::kBricks), drawn(Pattern::kPlanks), drawn(Pattern::kTiles), drawn(Pattern::kSpeckles)};
  return kTextures.at(static_cast<std::size_t>(pattern));
}
}  // namespace f1tenth_sim2d
