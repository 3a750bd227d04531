#include "loaders/visuals/material_script.h"

#include <filesystem>
#include <mutex>
#include <sstream>

#include "loaders/files/files.h"

namespace f1tenth_sim2d
{
namespace
{
Colour readColour(std::istream & words)
{
  Colour colour;
  words >> colour.red >> colour.green >> colour.blue;
  return colour;
}

/// A pass reads "diffuse 1 1 1 1"; of several passes and texture units the first counts.
void readLine(const std::string & line, ScriptedMaterial & material)
{
  std::istringstream words(line);
  std::string key;
  words >> key;
  Colour colour = readColour(words);
  if (key == "diffuse" && words) {
    material.diffuse = colour;
  } else if (key == "emissive" && words) {
    material.emission = colour;
  } else if (key == "texture" && material.texture.empty()) {
    std::istringstream(line) >> key >> material.texture;
  }
}

struct Heading
{
  std::string name;
  std::string parent;
};

/// "material NAME" or "material NAME : PARENT"; the name is empty for any other line.
Heading headingIn(const std::string & line)
{
  std::istringstream words(line);
  std::string keyword;
  Heading heading;
  words >> keyword;
  if (keyword == "material") {
    std::string colon;
    words >> heading.name >> colon >> heading.parent;
  }
  return heading;
}

ScriptedMaterials materialsIn(const std::string & text)
{
  ScriptedMaterials materials;
  ScriptedMaterial * current = nullptr;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (const Heading heading = headingIn(line); !heading.name.empty()) {
      const auto parent = materials.find(heading.parent);
      const ScriptedMaterial start = parent == materials.end() ? ScriptedMaterial{} : parent->second;
      current = &(materials[heading.name] = start);
    } else if (current) {
      readLine(line, *current);
    }
  }
  return materials;
}

struct KnownScript
{
  std::filesystem::file_time_type changed;
  std::shared_ptr<const ScriptedMaterials> materials;
};
}  // namespace

std::shared_ptr<const ScriptedMaterials> readMaterialScript(const std::string & path)
{
  static std::mutex mutex;
  static std::map<std::string, KnownScript> known;
  const std::lock_guard<std::mutex> lock(mutex);
  std::error_code ignored;
  const auto changed = std::filesystem::last_write_time(path, ignored);
  KnownScript & script = known[path];
  if (!script.materials || script.changed != changed) {
    script = {changed, std::make_shared<const ScriptedMaterials>(materialsIn(readFile(path)))};
  }
  return script.materials;
}
}  // namespace f1tenth_sim2d
