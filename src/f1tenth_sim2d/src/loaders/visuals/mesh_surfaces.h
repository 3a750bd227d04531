#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loaders/shapes/mesh_file.h"
#include "loaders/visuals/material.h"

namespace f1tenth_sim2d
{
/// What is seen of a mesh file: a surface for each of its materials, or all of them in the one that is given.
/// @param warning  filled in where a texture, or the materials, of the file cannot be used
/// @throws Error for a file that cannot be read, or that holds nothing of what is wanted
std::vector<Surface> surfacesOfMesh(
  const std::string & path, const MeshSelection & selection, const std::optional<Material> & given,
  std::string & warning);
}  // namespace f1tenth_sim2d
