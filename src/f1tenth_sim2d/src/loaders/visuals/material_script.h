#pragma once

#include <optional>
#include <string>

#include "render/texture.h"

namespace f1tenth_sim2d
{
/// What is of use in a material of an OGRE script.
struct ScriptedMaterial
{
  Colour diffuse{1.0F, 1.0F, 1.0F};
  Colour emission;
  std::string texture;  ///< file; empty: none
};

/// @param text  of a .material file
/// @param name  of a material; one that inherits from another of the file begins as that one
/// @return none if the text does not define it
std::optional<ScriptedMaterial> findMaterial(const std::string & text, const std::string & name);
}  // namespace f1tenth_sim2d
