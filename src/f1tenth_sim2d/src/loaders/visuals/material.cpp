#include "loaders/visuals/material.h"

#include <algorithm>
#include <filesystem>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"
#include "loaders/visuals/gazebo_materials.h"
#include "loaders/visuals/material_script.h"
#include "loaders/visuals/texture_file.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

const std::string kOfGazebo = "Gazebo/";

/// Red, green, blue and maybe alpha, which is not used: nothing is transparent.
std::optional<Colour> toColour(const Element & element, const std::string & text)
{
  const auto numbers = numbersIn(text);
  if (!numbers || numbers->size() < 3) {
    element.fail("'" + text + "' is no colour, allowed are three or four numbers from 0 to 1");
  }
  const auto share = [&numbers](std::size_t i) {
    return static_cast<float>(std::max(0.0, std::min(numbers->at(i), 1.0)));
  };
  return Colour{share(0), share(1), share(2)};
}

std::optional<Colour> colourOf(const Element & material, const char * tag)
{
  const Element colour = material.child(tag);
  return colour ? toColour(colour, colour.text()) : std::nullopt;
}

/// The part of a robot that defines a material by its name.
Element definitionOf(const Element & material)
{
  if (material.child("color") || material.child("texture")) {
    return material;
  }
  const Element robot = material.root();
  std::vector<Element> places{robot};
  for (const Element & link : robot.children("link")) {
    const std::vector<Element> visuals = link.children("visual");
    places.insert(places.end(), visuals.begin(), visuals.end());
  }
  for (const Element & place : places) {
    for (const Element & each : place.children("material")) {
      if (each.name() == material.name() && (each.child("color") || each.child("texture"))) {
        return each;
      }
    }
  }
  return material;
}

/// The .material files that a URI means: one, or those of a folder.
std::vector<std::string> scriptFiles(const std::string & uri, const FileFinder & files)
{
  const std::string path = files.find(uri);
  if (isFile(path)) {
    return {path};
  }
  std::vector<std::string> found;
  for (const fs::directory_entry & entry : fs::directory_iterator(path)) {
    if (entry.path().extension() == ".material") {
      found.push_back(entry.path().string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// A texture lies beside the script, in a folder that the material names, or in `textures` beside that of the script.
std::string findTexture(
  const std::string & texture, const std::string & script, const MaterialDescription & material,
  const FileFinder & files)
{
  const fs::path folder = fs::path(script).parent_path();
  std::vector<fs::path> folders{folder, folder.parent_path() / "textures"};
  for (const std::string & uri : material.scripts) {
    folders.emplace_back(files.uris->findFrom(files.folder, uri));
  }
  for (const fs::path & each : folders) {
    if (isFile((each / texture).string())) {
      return (each / texture).string();
    }
  }
  throw Error("the texture " + texture + " of " + script + " is not found");
}

void applyScript(const MaterialDescription & description, const FileFinder & files, LoadedMaterial & loaded)
{
  if (description.script.rfind(kOfGazebo, 0) == 0) {
    if (const auto known = gazeboMaterial(description.script.substr(kOfGazebo.size()))) {
      loaded.material.diffuse = known->colour;
      loaded.material.emission = known->glows ? known->colour : Colour{};
      loaded.material.texture = textureOf(known->pattern);
      loaded.scale.tile = kPatternSide;
      return;
    }
  }
  for (const std::string & uri : description.scripts) {
    for (const std::string & file : scriptFiles(uri, files)) {
      const auto materials = readMaterialScript(file);
      if (const auto found = materials->find(description.script); found != materials->end()) {
        const ScriptedMaterial & scripted = found->second;
        loaded.material.diffuse = scripted.diffuse;
        loaded.material.emission = scripted.emission;
        if (!scripted.texture.empty()) {
          loaded.material.texture = readTexture(findTexture(scripted.texture, file, description, files));
        }
        return;
      }
    }
  }
  throw Error("there is no material " + description.script);
}
}  // namespace

std::string FileFinder::find(const std::string & uri) const
{
  const std::string path = uris->findFrom(folder, uri);
  if (path.empty()) {
    throw Error(uri + " is not found; searched: " + uris->searchedFolders());
  }
  return path;
}

MaterialDescription readMaterial(const Element & material)
{
  MaterialDescription description;
  description.diffuse = colourOf(material, "diffuse");
  description.ambient = colourOf(material, "ambient");
  description.emission = colourOf(material, "emissive").value_or(Colour{});
  const Element script = material.child("script");
  // Until SDF 1.3 the name was the text of the script itself.
  description.script = script.child("name") ? script.child("name").text() : script.text();
  for (const Element & uri : script.children("uri")) {
    description.scripts.push_back(uri.text());
  }
  description.texture = material.child("pbr").child("metal").child("albedo_map").text();
  return description;
}

MaterialDescription readUrdfMaterial(const Element & material, const std::string & given)
{
  MaterialDescription description;
  description.script = given;
  if (!given.empty() || !material) {
    return description;
  }
  const Element definition = definitionOf(material);
  if (const Element colour = definition.child("color")) {
    description.diffuse = toColour(colour, colour.attribute("rgba"));
  }
  description.texture = definition.child("texture").attribute("filename");
  return description;
}

LoadedMaterial loadMaterial(const MaterialDescription & description, const FileFinder & files)
{
  LoadedMaterial loaded;
  loaded.material.diffuse = description.ambient.value_or(loaded.material.diffuse);
  try {
    if (!description.script.empty()) {
      applyScript(description, files, loaded);
    }
    if (!description.texture.empty()) {
      loaded.material.texture = readTexture(files.find(description.texture));
      loaded.material.diffuse = {1.0F, 1.0F, 1.0F};
    }
  } catch (const std::exception & error) {
    loaded.warning = std::string(error.what()) + ": drawn in a plain colour";
  }
  loaded.material.diffuse = description.diffuse.value_or(loaded.material.diffuse);
  const Colour & glow = description.emission;
  loaded.material.emission = glow.red + glow.green + glow.blue > 0.0F ? glow : loaded.material.emission;
  return loaded;
}
}  // namespace f1tenth_sim2d
