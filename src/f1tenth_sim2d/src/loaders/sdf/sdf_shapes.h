#pragma once

#include <sdf/Collision.hh>
#include <string>

#include "f1tenth_sim2d/world_model.h"
#include "loaders/files/mesh_library.h"

namespace f1tenth_sim2d
{
/// A collision element as a solid, its pose still to be set.
/// @param scoped_name  "model::link::collision"
/// @throws LoadError for a geometry that is not supported, a size that is not positive, a number that is not finite
Solid readCollision(
  const sdf::Collision & collision, const std::string & scoped_name, const std::string & file, MeshLibrary & meshes);
}  // namespace f1tenth_sim2d
