#pragma once

#include <string>

#include "loaders/shapes/mesh_parts.h"

namespace f1tenth_sim2d
{
/// Reads a mesh file as Gazebo does: DAE in its <unit>, its <up_axis> ignored; STL and OBJ in metres.
/// @throws std::runtime_error saying what is wrong with the file
MeshParts readParts(const std::string & path);
}  // namespace f1tenth_sim2d
