#pragma once

#include <map>
#include <string>

#include "loaders/model/model.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// The saved states of the models in a world that Gazebo saved: a <model> of its <state> by the model's name.
std::map<std::string, Element> savedModels(const Element & world, WarningCollector & warnings);

/// Puts a model, its links and those nested in it where Gazebo saved them, and in the size that they had.
/// @param pose  of the model in the world
/// @throws LoadError
void restore(const Element & saved, Pose3 & pose, Model & model, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
