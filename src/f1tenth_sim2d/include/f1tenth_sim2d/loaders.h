#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Where model://, file:// and package:// URIs are looked up, in order.
struct SearchPath
{
  std::vector<std::string> model_folders;    ///< each holds models, one folder per model, or other files
  std::vector<std::string> package_folders;  ///< ROS packages are looked for in these and all folders below them
};

/// GAZEBO_MODEL_PATH with GAZEBO_RESOURCE_PATH after it, and ROS_PACKAGE_PATH. The only function of the loaders that reads the environment.
SearchPath searchPathFromEnvironment();

/// Reads a world: an SDF file, or an occupancy-grid map (.yaml) in map_server's format.
/// URIs in an SDF file are looked up in the model folders, then beside the file, then in packages. The occupied cells
/// of a map are walls, exactly along the edges of the pixels; the start is on the centreline if X_centerline.csv lies
/// beside X_map.yaml.
/// @throws LoadError for a missing or malformed file and for what would make the simulation wrong
WorldDescription loadWorld(const std::string & path, const SearchPath & search_path = {});

/// An occupancy-grid map.
struct MapGrid
{
  std::size_t columns{0};
  std::size_t rows{0};
  double resolution{0.0};          ///< m, edge length of a cell
  Pose2 origin;                    ///< of the lower left corner, m and rad
  std::vector<std::int8_t> cells;  ///< row by row, the lowest first: one of those below

  static constexpr std::int8_t kOccupied = 100, kFree = 0, kUnknown = -1;

  bool isOccupied(std::size_t column, std::size_t row) const { return cells[row * columns + column] == kOccupied; }
};

/// Reads a map in map_server's format. What is neither occupied nor free is unknown, in mode scale, too.
/// @throws LoadError naming file, line and key
MapGrid readMap(const std::string & path);

/// A point in the middle of a road, and how far the road reaches to either side, m.
struct CentrelinePoint
{
  double x;
  double y;
  double width_right;
  double width_left;
};

struct Centreline
{
  std::vector<CentrelinePoint> points;  ///< no two that follow each other are the same, nor the last and the first
  bool has_widths{false};               ///< without, widths are 0
};

/// Reads an X_centerline.csv of f1tenth_racetracks: `x_m, y_m, w_tr_right_m, w_tr_left_m`, or the first two alone. A
/// point that is there several times counts once.
/// @throws LoadError naming file and line, also for fewer than two different points
Centreline readCentreline(const std::string & path);

/// The ground and nothing on it.
WorldDescription emptyWorld();

/// A model and those nested in it.
struct LoadedModel
{
  std::vector<ModelDescription> models;  ///< the outer one first
  std::vector<std::string> warnings;
};

/// Whether a URDF or SDF model has parts that only a car has here: joints that turn, sensors or plugins.
/// @throws LoadError for text that is not XML
bool describesCar(const std::string & xml, const std::string & source);

/// Reads a URDF or SDF model that is not a car from a string.
/// @param name  of the model in the world
/// @param pose  in the world, to which the pose that the model has in its description is relative
/// @throws LoadError
LoadedModel loadModel(
  const std::string & xml, const std::string & name, const Pose3 & pose, const std::string & source,
  const SearchPath & search_path = {});

/// Reads a URDF (with <gazebo> tags) or SDF model from a string.
/// @param name           the car's name
/// @param source         what error messages call the text
/// @param ros_namespace  of the car, without leading or trailing slash; by default its name
/// @throws LoadError
CarDescription loadCar(
  const std::string & xml, const std::string & name, const std::string & source, const SearchPath & search_path = {},
  const std::optional<std::string> & ros_namespace = std::nullopt);
}  // namespace f1tenth_sim2d
