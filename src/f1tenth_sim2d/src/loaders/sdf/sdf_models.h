#pragma once

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
  const sdf::Model & model, const Pose3 & pose, const std::string & file, MeshLibrary & meshes,
  std::vector<ModelDescription> & models, WarningCollector & warnings);

struct Inertia
{
  double mass{0.0};                ///< kg
  Eigen::Vector3d centre_of_mass;  ///< m, in the frame of the model
  double about_z{0.0};             ///< kg m^2, about the centre of mass
};

/// That of all of a model's own links together.
/// @throws LoadError
Inertia inertiaOf(const sdf::Model & model, const std::string & file);

/// @param frame  in which the result is given; empty: the frame of the element around it
/// @throws LoadError
Pose3 resolvePose(
  const sdf::SemanticPose & pose, const std::string & frame, const sdf::ElementPtr & element, const std::string & file);

/// The tags of a <plugin>, nested ones as "outer/inner".
PluginElement readPlugin(const sdf::ElementPtr & element);
}  // namespace f1tenth_sim2d
