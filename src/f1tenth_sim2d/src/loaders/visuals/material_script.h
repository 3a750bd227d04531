#pragma once

#include <map>
#include <memory>
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

/// Those of a script by their names. One that inherits from another of the file begins as that one.
using ScriptedMaterials = std::map<std::string, ScriptedMaterial>;

/// What a .material file defines; it is read again only if it has changed. From any thread.
/// @throws LoadError for a file that cannot be read
std::shared_ptr<const ScriptedMaterials> readMaterialScript(const std::string & path);
}  // namespace f1tenth_sim2d
