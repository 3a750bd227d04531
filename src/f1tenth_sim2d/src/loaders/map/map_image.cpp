#include "loaders/map/map_image.h"

#include <algorithm>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr std::size_t kPixelsMax = 100'000'000;
}  // namespace

double MapImage::brightness(std::size_t pixel, bool with_alpha) const
{
  const std::size_t count = channels == 4 && !with_alpha ? 3 : channels;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += samples[pixel * channels + i];
  }
  return sum / static_cast<double>(count);
}

void requireMapSize(const std::string & path, std::size_t width, std::size_t height)
{
  if (width == 0 || height == 0 || width > kPixelsMax / height) {
    throw LoadError(
      path, "",
      "has " + std::to_string(width) + " x " + std::to_string(height) + " pixels, allowed are 1 to " +
        std::to_string(kPixelsMax));
  }
}

MapImage readMapImage(const std::string & path)
{
  const std::string bytes = readFile(path);
  if (bytes.rfind("\x89PNG", 0) == 0) {
    return readPng(path, bytes);
  }
  if (bytes.rfind("P5", 0) == 0 || bytes.rfind("P2", 0) == 0) {
    return readPgm(path, bytes);
  }
  throw LoadError(path, "", "is no image that is known here, allowed are PNG and PGM");
}
}  // namespace f1tenth_sim2d
