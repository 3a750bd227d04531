#include "loaders/map/map_world.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>

#include "loaders/map/map_centreline.h"
#include "loaders/map/map_image.h"
#include "loaders/map/map_metadata.h"
#include "loaders/map/map_walls.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kWallHeight = 2.5;  // m, above every lidar of a car; a map does not say

/// map_server's rule: darker than the threshold is occupied, all else is not.
bool isOccupied(double brightness, const MapMetadata & metadata)
{
  const double p = metadata.negate ? 255.0 - brightness : brightness;
  if (metadata.mode == MapMetadata::Mode::kRaw) {
    return p <= 100.0 && p > 100.0 * metadata.occupied_thresh;
  }
  return (255.0 - p) / 255.0 > metadata.occupied_thresh;
}

CellGrid cellsOf(const MapImage & image, const MapMetadata & metadata)
{
  // As map_server has always done it: in trinary mode alpha counts like a colour.
  const bool with_alpha = metadata.mode == MapMetadata::Mode::kTrinary;
  CellGrid grid{image.width, image.height, {}};
  grid.occupied.reserve(image.width * image.height);
  for (std::size_t row = image.height; row-- > 0;) {
    for (std::size_t column = 0; column < image.width; ++column) {
      const double brightness = image.brightness(row * image.width + column, with_alpha);
      grid.occupied.push_back(isOccupied(brightness, metadata) ? 1 : 0);
    }
  }
  return grid;
}
}  // namespace

bool isMapFile(const std::string & path)
{
  const std::string ending = boost::algorithm::to_lower_copy(std::filesystem::path(path).extension().string());
  return ending == ".yaml" || ending == ".yml";
}

WorldDescription loadMapWorld(const std::string & path)
{
  const MapMetadata metadata = readMapMetadata(path);
  const MapImage image = readMapImage(metadata.image);
  requireNear(metadata, image.width, image.height, path);
  const CellGrid grid = cellsOf(image, metadata);
  WorldDescription world;
  world.file = path;
  world.name = std::filesystem::path(path).stem().string();
  world.warnings = metadata.warnings;
  world.start = startOnCentreline(path).value_or(Pose2{});
  ModelDescription & map = world.models.emplace_back();
  map.name = "map";
  map.pose = {metadata.origin.x, metadata.origin.y, 0.0, 0.0, 0.0, metadata.origin.yaw};
  map.is_static = true;
  Solid & walls = map.solids.emplace_back();
  walls.name = "map::walls::occupied";
  walls.shape = wallsOf(grid, metadata.resolution, kWallHeight);
  return world;
}
}  // namespace f1tenth_sim2d
