#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// The YAML file of a map, in map_server's format.
struct MapMetadata
{
  enum class Mode
  {
    kTrinary,
    kScale,
    kRaw
  };

  std::string image;       ///< path
  double resolution{0.0};  ///< m, edge length of a cell
  int resolution_line{0};  ///< line of the file where it is given
  Pose2 origin;            ///< of the lower left corner of the image
  bool negate{false};
  double occupied_thresh{0.65};
  double free_thresh{0.196};
  Mode mode{Mode::kTrinary};
  std::vector<std::string> warnings;  ///< keys that have no meaning
};

/// @throws LoadError naming file, line and key
MapMetadata readMapMetadata(const std::string & path);

/// @param width, height  of the image, pixels
/// @throws LoadError unless all of a map is within 100 km of the world's origin
void requireNear(const MapMetadata & metadata, std::size_t width, std::size_t height, const std::string & path);
}  // namespace f1tenth_sim2d
