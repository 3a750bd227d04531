#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// The pixels of a map, eight bits per channel, top row first.
struct MapImage
{
  std::size_t width{0};
  std::size_t height{0};
  std::size_t channels{1};  ///< 1 grey, 3 RGB, 4 RGBA
  std::vector<std::uint8_t> samples;

  /// Mean of all channels but alpha, and of alpha too if asked for: 0 to 255.
  double brightness(std::size_t pixel, bool with_alpha) const;
};

/// Reads a PNG or PGM file, whatever its name ends with.
/// @throws LoadError
MapImage readMapImage(const std::string & path);

/// @throws LoadError for an image without pixels or with more than a map can have
void requireMapSize(const std::string & path, std::size_t width, std::size_t height);

/// @param bytes  the whole file, for both
MapImage readPng(const std::string & path, const std::string & bytes);
MapImage readPgm(const std::string & path, const std::string & bytes);
}  // namespace f1tenth_sim2d
