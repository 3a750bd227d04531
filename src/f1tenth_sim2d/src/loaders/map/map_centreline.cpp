#include "loaders/map/map_centreline.h"

#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>
#include <vector>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
std::filesystem::path centrelineOf(const std::filesystem::path & map)
{
  const std::string stem = map.stem().string();
  const std::string track = boost::algorithm::ends_with(stem, "_map") ? stem.substr(0, stem.size() - 4) : stem;
  return map.parent_path() / (track + "_centerline.csv");
}

std::optional<Vec2> readPoint(const std::string & line)
{
  std::istringstream stream(line);
  stream.imbue(std::locale::classic());
  Vec2 point;
  char comma = 0;
  stream >> point.x >> comma >> point.y;
  const bool complete = static_cast<bool>(stream) && comma == ',' && std::isfinite(point.x) && std::isfinite(point.y);
  return complete ? std::optional<Vec2>(point) : std::nullopt;
}

/// The first two points.
std::vector<Vec2> readPoints(const std::string & path)
{
  std::ifstream file(path);
  std::vector<Vec2> points;
  std::string line;
  for (int number = 1; points.size() < 2 && std::getline(file, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') {
      continue;
    }
    const std::optional<Vec2> point = readPoint(line);
    if (!point) {
      throw LoadError(path + ":" + std::to_string(number), "", "found '" + line + "', allowed is x (m), y (m), …");
    }
    points.push_back(*point);
  }
  return points;
}
}  // namespace

std::optional<Pose2> startOnCentreline(const std::string & map_path)
{
  const std::filesystem::path path = centrelineOf(map_path);
  if (!std::filesystem::is_regular_file(path)) {
    return std::nullopt;
  }
  const std::vector<Vec2> points = readPoints(path.string());
  if (points.size() < 2) {
    throw LoadError(path.string(), "", "has " + std::to_string(points.size()) + " points, allowed are 2 or more");
  }
  return Pose2{points[0].x, points[0].y, std::atan2(points[1].y - points[0].y, points[1].x - points[0].x)};
}
}  // namespace f1tenth_sim2d
