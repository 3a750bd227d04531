#pragma once

#include <memory>
#include <string>

#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Which part of a mesh file is wanted, as in SDF's <mesh>.
struct MeshSelection
{
  std::string submesh;  ///< name of a node or geometry; empty: everything
  bool centred{false};  ///< move the middle of the submesh's bounding box to the origin
  Eigen::Vector3d scale{1, 1, 1};
};

struct MeshSurface
{
  std::shared_ptr<const TriangleMesh> triangles;
  std::size_t left_out;  ///< triangles with a corner that is not finite or farther than 100 km from the mesh's origin
};

/// A mesh file as Gazebo reads it: DAE in its <unit>, its <up_axis> ignored; STL and OBJ in metres.
/// @throws Error saying what is wrong with the file, or which submeshes there are
MeshSurface readMeshFile(const std::string & path, const MeshSelection & selection);
}  // namespace f1tenth_sim2d
