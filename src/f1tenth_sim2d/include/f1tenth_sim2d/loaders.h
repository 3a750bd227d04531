#pragma once

#include <string>
#include <vector>

#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Folders in which model:// URIs are looked up, in order.
using ModelPath = std::vector<std::string>;

/// GAZEBO_MODEL_PATH, split at colons. The only function of the loaders that reads the environment.
ModelPath modelPathFromEnvironment();

/// Reads a world: an SDF file through libsdformat, or an occupancy-grid map (.yaml) in map_server's format.
/// model:// and file:// of an SDF file resolve over model_path, then beside the file. The occupied cells of a map are
/// walls, exactly along the edges of the pixels; the start is on the centreline if X_centerline.csv lies beside
/// X_map.yaml.
/// @throws LoadError for a missing or malformed file and for what would make the simulation wrong
WorldDescription loadWorld(const std::string & path, const ModelPath & model_path = {});

/// The ground and nothing on it.
WorldDescription emptyWorld();

/// Reads a URDF (with <gazebo> tags) or SDF model from a string.
/// @param name    the car's name and ROS namespace
/// @param source  what error messages call the text
/// @throws LoadError
CarDescription loadCar(const std::string & xml, const std::string & name, const std::string & source);
}  // namespace f1tenth_sim2d
