#include "loaders/map/map_image.h"

#include <leptonica/allheaders.h>

#include <algorithm>
#include <memory>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"
#include "loaders/map/pnm_white.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr std::size_t kPixelsMax = 100'000'000;

struct Destroy
{
  void operator()(Pix * pix) const { pixDestroy(&pix); }
};
using PixOwner = std::unique_ptr<Pix, Destroy>;

const l_uint8 * dataOf(const std::string & bytes)
{
  return reinterpret_cast<const l_uint8 *>(bytes.data());
}

/// Kind of a file by its first bytes.
std::string kindOf(const std::string & path, const std::string & bytes)
{
  l_int32 format = IFF_UNKNOWN;
  if (bytes.size() >= 12) {  // else Leptonica reads beyond
    findFileFormatBuffer(dataOf(bytes), &format);
  }
  switch (format) {
    case IFF_PNG:
      return "PNG";
    case IFF_PNM:
      return "PNM";
    case IFF_BMP:
      return "BMP";
    case IFF_JFIF_JPEG:
      return "JPG";
    case IFF_GIF:
      return "GIF";
    default:
      if (L_FORMAT_IS_TIFF(format)) {
        return "TIFF";
      }
      throw LoadError(
        path, "", "is no image that is known here, allowed are PNG, PGM, PPM, PBM, BMP, JPG, TIFF and GIF");
  }
}

void requireMapSize(const std::string & path, l_int32 width, l_int32 height)
{
  if (width < 1 || height < 1 || static_cast<std::size_t>(width) > kPixelsMax / static_cast<std::size_t>(height)) {
    throw LoadError(
      path, "",
      "has " + std::to_string(width) + " x " + std::to_string(height) + " pixels, allowed are 1 to " +
        std::to_string(kPixelsMax));
  }
}

PixOwner decoded(const std::string & path, const std::string & kind, const std::string & bytes)
{
  setMsgSeverity(L_SEVERITY_NONE);
  l_int32 width = 0;
  l_int32 height = 0;
  l_int32 channels = 0;
  l_int32 has_palette = 0;
  if (pixReadHeaderMem(dataOf(bytes), bytes.size(), nullptr, &width, &height, nullptr, &channels, &has_palette) == 0) {
    requireMapSize(path, width, height);
  }
  PixOwner pix(pixReadMem(dataOf(bytes), bytes.size()));
  if (!pix) {
    throw LoadError(path, "", kind + " image: is broken or ends too early");
  }
  requireMapSize(path, pixGetWidth(pix.get()), pixGetHeight(pix.get()));
  if (channels == 1 && has_palette == 0 && pixGetSpp(pix.get()) == 4) {  // Leptonica forgets the greys
    throw LoadError(path, "", kind + " image: one of its greys is transparent, allowed is an alpha channel");
  }
  return pix;
}

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
  const std::string kind = kindOf(path, bytes);
  const unsigned white = kind == "PNM" ? takeWhite(path, bytes) : 255;
  const PixOwner original = decoded(path, kind, bytes);
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
