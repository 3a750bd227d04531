#pragma once

#include <optional>
#include <string>

#include "loaders/visuals/patterns.h"
#include "render/scene.h"

namespace f1tenth_sim2d
{
/// A material that Gazebo brings along.
struct GazeboMaterial
{
  Colour colour;
  Pattern pattern{Pattern::kNone};
  bool glows{false};
};

/// @param name  without "Gazebo/"; none for one that is not known
std::optional<GazeboMaterial> gazeboMaterial(const std::string & name);
}  // namespace f1tenth_sim2d
