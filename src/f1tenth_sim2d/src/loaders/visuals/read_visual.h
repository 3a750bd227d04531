#pragma once

#include <functional>
#include <string>

#include "f1tenth_sim2d/visual.h"
#include "loaders/shapes/mesh_library.h"

namespace f1tenth_sim2d
{
/// A <visual> of SDF or of a URDF. Nothing in it is an error: what cannot be drawn is left out once somebody looks, with
/// a warning.
/// @param pose      reads that of the visual in the model
/// @param material  that <gazebo> gives the link of a URDF; empty: none
Visual readVisual(
  const Element & visual, const std::function<Pose3()> & pose, MeshLibrary & meshes, const std::string & material = {});
}  // namespace f1tenth_sim2d
