#pragma once

#include <string>

#include "f1tenth_sim2d/visual.h"
#include "loaders/frames/frame_scope.h"
#include "loaders/shapes/mesh_library.h"

namespace f1tenth_sim2d
{
/// A <visual> of SDF. Nothing in it is an error: what cannot be drawn is left out once somebody looks, with a warning.
/// @param link  that it is part of
Visual readVisual(const Element & visual, const std::string & link, const FrameScope & frames, MeshLibrary & meshes);

/// A <visual> of a URDF, likewise.
/// @param link      pose of its link in the model
/// @param material  that <gazebo> gives the link; empty: none
Visual readUrdfVisual(const Element & visual, const Pose3 & link, const std::string & material, MeshLibrary & meshes);
}  // namespace f1tenth_sim2d
