#pragma once

#include <string>

#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Whether a path names an occupancy-grid map rather than an SDF world: by its ending.
bool isMapFile(const std::string & path);

/// @throws LoadError
WorldDescription loadMapWorld(const std::string & path);
}  // namespace f1tenth_sim2d
