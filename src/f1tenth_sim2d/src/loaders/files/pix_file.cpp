#include "loaders/files/pix_file.h"

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
const l_uint8 * dataOf(const std::string & bytes)
{
  return reinterpret_cast<const l_uint8 *>(bytes.data());
}

void requireSize(const std::string & path, l_int32 width, l_int32 height)
{
  if (width < 1 || height < 1 || static_cast<std::size_t>(width) > kPixelsMax / static_cast<std::size_t>(height)) {
    throw LoadError(
      path, "",
      "has " + std::to_string(width) + " x " + std::to_string(height) + " pixels, allowed are 1 to " +
        std::to_string(kPixelsMax));
  }
}
}  // namespace

std::string kindOfImage(const std::string & path, const std::string & bytes)
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

PixOwner readPix(const std::string & path, const std::string & bytes)
{
  setMsgSeverity(L_SEVERITY_NONE);
  const std::string kind = kindOfImage(path, bytes);
  l_int32 width = 0;
  l_int32 height = 0;
  l_int32 channels = 0;
  l_int32 has_palette = 0;
  if (pixReadHeaderMem(dataOf(bytes), bytes.size(), nullptr, &width, &height, nullptr, &channels, &has_palette) == 0) {
    requireSize(path, width, height);
  }
  PixOwner pix(pixReadMem(dataOf(bytes), bytes.size()));
  if (!pix) {
    throw LoadError(path, "", kind + " image: is broken or ends too early");
  }
  requireSize(path, pixGetWidth(pix.get()), pixGetHeight(pix.get()));
  if (channels == 1 && has_palette == 0 && pixGetSpp(pix.get()) == 4) {  // Leptonica forgets the greys
    throw LoadError(path, "", kind + " image: one of its greys is transparent, allowed is an alpha channel");
  }
  return pix;
}
}  // namespace f1tenth_sim2d
