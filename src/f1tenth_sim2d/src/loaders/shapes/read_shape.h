#pragma once

#include <string>

#include "loaders/shapes/mesh_library.h"
#include "loaders/xml/element.h"

namespace f1tenth_sim2d
{
/// Shape of a <geometry> of SDF.
/// @param pose  of the collision; a plane is turned to its normal
/// @throws LoadError
Shape readShape(const Element & geometry, MeshLibrary & meshes, Pose3 & pose);

/// Shape of a <geometry> of a URDF.
/// @throws LoadError
Shape readUrdfShape(const Element & geometry, MeshLibrary & meshes);
}  // namespace f1tenth_sim2d
