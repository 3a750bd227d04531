#pragma once

#include <memory>
#include <string>

#include "loaders/shapes/mesh_parts.h"

namespace f1tenth_sim2d
{
/// The parts of a mesh file, which a process of its own reads, once until the file changes. From any thread.
/// @throws Error saying what is wrong with the file
std::shared_ptr<const MeshParts> partsOfFile(const std::string & path);
}  // namespace f1tenth_sim2d
