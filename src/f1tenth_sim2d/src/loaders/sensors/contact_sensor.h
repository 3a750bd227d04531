#pragma once

#include <string>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "loaders/xml/element.h"

namespace f1tenth_sim2d
{
/// Scoped names of the solids that a contact sensor watches. A collision may be named as in the URDF, although joining
/// links that are fixed to each other has renamed it, or with its scope.
/// @throws LoadError for a name that no solid has
std::vector<std::string> collisionsOfContactSensor(const Element & sensor, const std::vector<Solid> & solids);
}  // namespace f1tenth_sim2d
