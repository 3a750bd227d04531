#pragma once

#include <string>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "loaders/model/model.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// Appends a model and those nested in it as the simulation takes them: each a rigid body of its own.
/// @param pose  of the model in the world
/// @throws LoadError for what would make the simulation wrong
void appendModel(
  const Model & model, const Pose3 & pose, std::vector<ModelDescription> & models, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
