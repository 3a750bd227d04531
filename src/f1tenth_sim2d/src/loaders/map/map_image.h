#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// How bright the pixels of a map are, top row first.
struct MapImage
{
  std::size_t width{0};
  std::size_t height{0};
  std::vector<std::uint16_t> sums;  ///< over the channels of a pixel, 0 to 255 each
  double channels{1.0};

  /// Mean of the channels: 0 to 255.
  double brightness(std::size_t pixel) const { return sums[pixel] / channels; }
};

/// Reads a PNG, PGM, PPM, PBM, BMP, JPG, TIFF or GIF file, whatever its name ends with.
/// @param alpha_counts  whether alpha counts like a colour; like map_server's library, TIFF always has it
/// @throws LoadError
MapImage readMapImage(const std::string & path, bool alpha_counts);
}  // namespace f1tenth_sim2d
