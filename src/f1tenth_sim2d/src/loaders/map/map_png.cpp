#include <png.h>

#include <memory>

#include "f1tenth_sim2d/errors.h"
#include "loaders/map/map_image.h"

namespace f1tenth_sim2d
{
namespace
{
[[noreturn]] void failWith(const png_image & png, const std::string & path)
{
  const std::string message = png.message;
  throw LoadError(path, "", "PNG image: " + (message == "read beyond end of data" ? "ends too early" : message));
}
}  // namespace

MapImage readPng(const std::string & path, const std::string & bytes)
{
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image *)> freed_at_end(&png, png_image_free);
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    failWith(png, path);
  }
  requireMapSize(path, png.width, png.height);
  const bool has_alpha = (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  const bool has_colour = (png.format & PNG_FORMAT_FLAG_COLOR) != 0;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  png.format = has_alpha ? PNG_FORMAT_RGBA : has_colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  MapImage image{png.width, png.height, PNG_IMAGE_SAMPLE_CHANNELS(png.format), {}};
  image.samples.resize(image.width * image.height * image.channels);
  if (png_image_finish_read(&png, nullptr, image.samples.data(), 0, nullptr) == 0) {
    failWith(png, path);
  }
  return image;
}
}  // namespace f1tenth_sim2d
