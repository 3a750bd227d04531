#pragma once

#include <vector>

#include "f1tenth_sim2d/section.h"

namespace f1tenth_sim2d
{
/// Lines in which a horizontal plane cuts a surface.
struct MeshOutlines
{
  std::vector<Outline> closed;  ///< counter-clockwise around solid matter, clockwise around hollows
  std::vector<Outline> open;    ///< from end to end
};

/// @param vertices  of the mesh, where it stands
MeshOutlines outlinesAt(const TriangleMesh & mesh, const std::vector<Eigen::Vector3d> & vertices, double z);
}  // namespace f1tenth_sim2d
