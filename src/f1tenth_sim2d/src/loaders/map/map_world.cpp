#include "loaders/map/map_world.h"

#include <workspace_support/maths/trigonometry.h>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>
#include <optional>

#include "f1tenth_sim2d/loaders.h"
#include "loaders/map/map_image.h"
#include "loaders/map/map_metadata.h"
#include "loaders/map/map_walls.h"
#include "loaders/visuals/patterns.h"
#include "render/scene.h"
#include "render/solid_mesh.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kWallHeight = 2.5;    // m, above every lidar of a car; a map does not give it
constexpr double kSeenHeight = 0.3;    // m, of the walls that cameras see
constexpr double kFloorSide = 2000.0;  // m

/// map_server's rule: darker than one threshold is occupied, lighter than the other one free.
std::int8_t cellOf(double brightness, const MapMetadata & metadata)
{
  const double p = metadata.negate ? 255.0 - brightness : brightness;
  const bool is_raw = metadata.mode == MapMetadata::Mode::kRaw;  // p is a value in percent, above 100 unknown
  const double occupancy = is_raw ? p / 100.0 : (255.0 - p) / 255.0;
  if (occupancy > metadata.occupied_thresh) {
    return occupancy > 1.0 ? MapGrid::kUnknown : MapGrid::kOccupied;
  }
  return occupancy < metadata.free_thresh ? MapGrid::kFree : MapGrid::kUnknown;
}

MapGrid gridOf(const MapMetadata & metadata)
{
  // As map_server has always done: in trinary mode alpha counts like a colour.
  const MapImage image = readMapImage(metadata.image, metadata.mode == MapMetadata::Mode::kTrinary);
  MapGrid grid{image.width, image.height, metadata.resolution, metadata.origin, {}};
  grid.cells.reserve(image.width * image.height);
  for (std::size_t row = image.height; row-- > 0;) {
    for (std::size_t column = 0; column < image.width; ++column) {
      grid.cells.push_back(cellOf(image.brightness(row * image.width + column), metadata));
    }
  }
  return grid;
}

MapGrid requiredNear(const MapMetadata & metadata, const std::string & path)
{
  MapGrid grid = gridOf(metadata);
  requireNear(metadata, grid.columns, grid.rows, path);
  return grid;
}

/// Walls as low as those of real tracks, and a floor.
class LookOfMap : public Look
{
public:
  explicit LookOfMap(std::string path) : path_(std::move(path)) {}

private:
  Appearance read() const override
  {
    const MapGrid grid = readMap(path_);
    Appearance seen;
    Surface & walls = seen.surfaces.emplace_back();
    walls.mesh = meshOf(wallsOf(grid, kSeenHeight), {kPatternSide});
    walls.material = {{0.80F, 0.78F, 0.72F}, {}, textureOf(Pattern::kSpeckles)};
    Surface & floor = seen.surfaces.emplace_back();
    floor.mesh = rectangle(kFloorSide, kFloorSide, {kPatternSide});
    floor.material = {{0.45F, 0.46F, 0.48F}, {}, textureOf(Pattern::kSpeckles)};
    floor.casts_shadow = false;
    return seen;
  }

  const std::string path_;
};

std::filesystem::path centrelineOf(const std::filesystem::path & map)
{
  const std::string stem = map.stem().string();
  const std::string track = boost::algorithm::ends_with(stem, "_map") ? stem.substr(0, stem.size() - 4) : stem;
  return map.parent_path() / (track + "_centerline.csv");
}

/// The first point of the track's centreline, X_centerline.csv beside X_map.yaml, headed for the second. Nothing if
/// there is no such file.
/// @throws LoadError naming file and line
std::optional<Pose2> startOnCentreline(const std::string & map_path)
{
  const std::filesystem::path path = centrelineOf(map_path);
  if (!std::filesystem::is_regular_file(path)) {
    return std::nullopt;
  }
  const Centreline line = readCentreline(path.string());
  const CentrelinePoint & first = line.points[0];
  const CentrelinePoint & second = line.points[1];
  return Pose2{first.x, first.y, maths::atan2(second.y - first.y, second.x - first.x)};
}
}  // namespace

bool isMapFile(const std::string & path)
{
  const std::string ending = boost::algorithm::to_lower_copy(std::filesystem::path(path).extension().string());
  return ending == ".yaml" || ending == ".yml";
}

MapGrid readMap(const std::string & path)
{
  return requiredNear(readMapMetadata(path), path);
}

WorldDescription loadMapWorld(const std::string & path)
{
  const MapMetadata metadata = readMapMetadata(path);
  const MapGrid grid = requiredNear(metadata, path);
  WorldDescription world;
  world.file = path;
  world.name = std::filesystem::path(path).stem().string();
  world.warnings = metadata.warnings;
  world.start = startOnCentreline(path).value_or(Pose2{});
  ModelDescription & map = world.models.emplace_back();
  map.name = "map";
  map.pose = {grid.origin.x, grid.origin.y, 0.0, 0.0, 0.0, grid.origin.yaw};
  map.is_static = true;
  map.visuals.push_back({{}, {}, std::make_shared<LookOfMap>(path)});
  Solid & walls = map.solids.emplace_back();
  walls.name = "map::walls::occupied";
  walls.shape = wallsOf(grid, kWallHeight);
  return world;
}
}  // namespace f1tenth_sim2d
