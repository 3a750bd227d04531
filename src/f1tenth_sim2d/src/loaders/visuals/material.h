#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "loaders/files/uri_lookup.h"
#include "loaders/xml/element.h"
#include "render/scene.h"
#include "render/solid_mesh.h"

namespace f1tenth_sim2d
{
/// A <material> as written; its files are read later.
struct MaterialDescription
{
  std::optional<Colour> diffuse;
  std::optional<Colour> ambient;
  Colour emission;
  std::string script;                ///< name of a material: "Gazebo/Grey"
  std::vector<std::string> scripts;  ///< URIs of files or folders where it is defined
  std::string texture;               ///< URI of an image; empty: none
};

/// A <material> of SDF; that of a visual that has none is all default.
/// @throws LoadError
MaterialDescription readMaterial(const Element & material);

/// The <material> of a visual of a URDF, whose colour may be defined elsewhere in the robot.
/// @param given  by <gazebo>: name of a material that replaces it; empty: none
/// @throws LoadError
MaterialDescription readUrdfMaterial(const Element & material, const std::string & given);

/// Where the files of a visual are looked up.
struct FileFinder
{
  std::shared_ptr<const UriLookup> uris;
  std::string folder;  ///< of the document

  /// @throws Error for one that is not found
  std::string find(const std::string & uri) const;
};

/// A material with its texture.
struct LoadedMaterial
{
  Material material;
  TextureScale scale;
  std::string warning;  ///< a plain colour is used instead; empty: none
};
LoadedMaterial loadMaterial(const MaterialDescription & material, const FileFinder & files);
}  // namespace f1tenth_sim2d
