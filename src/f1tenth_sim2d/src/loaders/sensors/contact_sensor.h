#pragma once

#include <string>
#include <vector>

#include "loaders/model/car_context.h"

namespace f1tenth_sim2d
{
/// Scoped names of the solids that a contact sensor watches: of each name a collision of the sensor's own link, or else
/// the only one of another link; of one with a scope ("LINK::COLLISION") that of the link. A collision may be named as
/// in the URDF, although joining links that are fixed to each other has renamed it.
/// @param link  on which the sensor is
/// @throws LoadError for a name that no solid has, or solids of several other links
std::vector<std::string> collisionsOfContactSensor(
  const Element & sensor, const std::string & link, const CarContext & context);
}  // namespace f1tenth_sim2d
