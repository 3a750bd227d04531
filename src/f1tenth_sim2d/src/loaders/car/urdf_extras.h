#pragma once

#include <tinyxml2.h>

#include "loaders/car/robot_text.h"

namespace f1tenth_sim2d
{
/// <transmission> of a URDF; what is not understood of them becomes a warning.
std::vector<TransmissionDescription> readTransmissions(const tinyxml2::XMLElement & robot, WarningCollector & warnings);

/// Tags of all <plugin> of a URDF, as they are written: by the plugin's name, then by tag.
std::map<std::string, std::map<std::string, std::string>> readPluginTags(const tinyxml2::XMLElement & robot);
}  // namespace f1tenth_sim2d
