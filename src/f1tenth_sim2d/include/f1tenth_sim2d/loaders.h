#pragma once

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
  std::vector<std::string> model_folders;    ///< each holds models, one folder per model
  std::vector<std::string> package_folders;  ///< ROS packages are looked for in these and all folders below them
};

/// GAZEBO_MODEL_PATH and ROS_PACKAGE_PATH. The only function of the loaders that reads the environment.
SearchPath searchPathFromEnvironment();

/// Reads a world: an SDF file, or an occupancy-grid map (.yaml) in map_server's format.
/// URIs in an SDF file are looked up in the model folders, then beside the file, then in packages. The occupied cells
/// of a map are walls, exactly along the edges of the pixels; the start is on the centreline if X_centerline.csv lies
/// beside X_map.yaml.
/// @throws LoadError for a missing or malformed file and for what would make the simulation wrong
WorldDescription loadWorld(const std::string & path, const SearchPath & search_path = {});

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
/// @param pose  of its frame in the world
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
