#pragma once

#include <leptonica/allheaders.h>

#include <cstddef>
#include <memory>
#include <string>

namespace f1tenth_sim2d
{
constexpr std::size_t kPixelsMax = 100'000'000;

struct DestroyPix
{
  void operator()(Pix * pix) const { pixDestroy(&pix); }
};
using PixOwner = std::unique_ptr<Pix, DestroyPix>;

/// Kind of an image file by its first bytes: PNG, PNM, BMP, JPG, GIF or TIFF.
/// @throws LoadError for any other
std::string kindOfImage(const std::string & path, const std::string & bytes);

/// Decodes the bytes of an image file.
/// @throws LoadError for one that is broken or has more than kPixelsMax pixels
PixOwner readPix(const std::string & path, const std::string & bytes);
}  // namespace f1tenth_sim2d
