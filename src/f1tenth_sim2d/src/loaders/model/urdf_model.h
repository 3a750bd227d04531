#pragma once

#include "loaders/model/model.h"
#include "loaders/shapes/mesh_library.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// Reads a <robot> with its <gazebo> tags as Gazebo does: links that a fixed joint connects become one, with their masses
/// added, their collision elements renamed ("base_link_fixed_joint_lump__bumper_collision_1") and their sensors moved.
/// @throws LoadError, also for a collision that Gazebo would leave out because its link has no mass
Model readUrdf(const Element & robot, MeshLibrary & meshes, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
