#pragma once

#include <ignition/math/Inertial.hh>
#include <sdf/Model.hh>
#include <string>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "loaders/files/mesh_library.h"
#include "loaders/files/warning_collector.h"

namespace f1tenth_sim2d
{
/// The collision elements of a model's own links, in the frame of the model; nested models are not among them.
/// @param scope  said before the names of the links, "outer::inner"
/// @throws LoadError
std::vector<Solid> readSolids(
  const sdf::Model & model, const std::string & scope, const std::string & file, MeshLibrary & meshes);

/// Appends a model of a world and the models nested in it, each as a rigid body of its own.
/// @param pose  of the model in the world
void appendModel(
  const sdf::Model & model, const ignition::math::Pose3d & pose, const std::string & file, MeshLibrary & meshes,
  std::vector<ModelDescription> & models, WarningCollector & warnings);

/// Mass, centre of mass and inertia of all of a model's own links together, in the frame of the model.
/// @throws LoadError
ignition::math::Inertiald inertiaOf(const sdf::Model & model, const std::string & file);

/// @param frame  in which the result is given; empty: the frame of the element around it
/// @throws LoadError
ignition::math::Pose3d resolvePose(
  const sdf::SemanticPose & pose, const std::string & frame, const sdf::ElementPtr & element, const std::string & file);

/// The tags of a <plugin>, nested ones as "outer/inner".
PluginElement readPlugin(const sdf::ElementPtr & element);
}  // namespace f1tenth_sim2d
