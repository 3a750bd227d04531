#include "loaders/map/map_image.h"

#include <algorithm>

#include "loaders/files/files.h"
#include "loaders/files/pix_file.h"
#include "loaders/map/pnm_white.h"

namespace f1tenth_sim2d
{
namespace
{
/// With 8 bits per pixel, grey, or with 32, RGB and alpha.
PixOwner withWholeBytes(const PixOwner & pix, bool with_alpha)
{
  PixOwner direct(pixRemoveColormap(pix.get(), REMOVE_CMAP_BASED_ON_SRC));
  if (with_alpha) {
    return PixOwner(pixConvertTo32(direct.get()));
  }
  return pixGetDepth(direct.get()) == 32 ? std::move(direct) : PixOwner(pixConvertTo8(direct.get(), 0));
}

/// Adds up the channels of each pixel.
void addUp(Pix & pix, bool with_alpha, unsigned white, MapImage & image)
{
  const bool is_grey = pixGetDepth(&pix) == 8;
  const bool is_opaque = pixGetSpp(&pix) < 4;
  const auto scaled = [white](unsigned value) { return std::min(value & 0xff, white) * 255 / white; };
  for (std::size_t row = 0; row < image.height; ++row) {
    l_uint32 * const words = pixGetData(&pix) + row * static_cast<std::size_t>(pixGetWpl(&pix));
    for (std::size_t column = 0; column < image.width; ++column) {
      const l_uint32 pixel = is_grey ? GET_DATA_BYTE(words, column) : words[column];
      const unsigned colours =
        is_grey ? scaled(pixel)
                : scaled(pixel >> L_RED_SHIFT) + scaled(pixel >> L_GREEN_SHIFT) + scaled(pixel >> L_BLUE_SHIFT);
      const unsigned alpha = !with_alpha ? 0 : is_opaque ? 0xff : pixel & 0xff;
      image.sums.push_back(static_cast<std::uint16_t>(colours + alpha));
    }
  }
}
}  // namespace

MapImage readMapImage(const std::string & path, bool alpha_counts)
{
  std::string bytes = readFile(path);
  const std::string kind = kindOfImage(path, bytes);
  const unsigned white = kind == "PNM" ? takeWhite(path, bytes) : 255;
  const PixOwner original = readPix(path, bytes);
  const bool has_alpha = kind == "TIFF" || pixGetSpp(original.get()) == 4;
  const PixOwner pix = withWholeBytes(original, has_alpha);
  MapImage image;
  image.width = static_cast<std::size_t>(pixGetWidth(pix.get()));
  image.height = static_cast<std::size_t>(pixGetHeight(pix.get()));
  image.channels = (pixGetDepth(pix.get()) == 8 ? 1 : 3) + (has_alpha && alpha_counts ? 1 : 0);
  image.sums.reserve(image.width * image.height);
  addUp(*pix, has_alpha && alpha_counts, white, image);
  return image;
}
}  // namespace f1tenth_sim2d
