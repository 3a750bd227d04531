#pragma once

#include <optional>

#include "loaders/shapes/mesh_library.h"
#include "loaders/xml/element.h"

namespace f1tenth_sim2d
{
/// What a <mesh> of SDF wants of its file; and of a URDF.
/// @throws LoadError
MeshSelection meshSelectionOf(const Element & mesh);
MeshSelection urdfMeshSelectionOf(const Element & mesh);

/// Shape of a <geometry> of SDF; none, with a warning, for one that a scale of 0 leaves nothing of.
/// @param pose  of the collision; a plane is turned to its normal
/// @throws LoadError
std::optional<Shape> readShape(const Element & geometry, MeshLibrary & meshes, Pose3 & pose);

/// The same of a URDF.
/// @throws LoadError
std::optional<Shape> readUrdfShape(const Element & geometry, MeshLibrary & meshes);
}  // namespace f1tenth_sim2d
