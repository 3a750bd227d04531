#include "loaders/sdf/world_text.h"

#include <algorithm>
#include <filesystem>
#include <sdf/parser.hh>

#include "loaders/files/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;
using tinyxml2::XMLElement;

const std::set<std::string> kSilent{
  "visual", "light", "physics", "gui", "scene", "wind", "atmosphere", "magnetic_field", "spherical_coordinates"};

void dropSilent(XMLElement & parent)
{
  for (XMLElement * child = parent.FirstChildElement(); child;) {
    XMLElement * const next = child->NextSiblingElement();
    if (kSilent.count(child->Name()) > 0) {
      parent.DeleteChild(child);
    } else if (std::string(child->Name()) != "plugin") {  // its tags are its own
      dropSilent(*child);
    }
    child = next;
  }
}

/// Paths of meshes beside the file become absolute: once read, an element no longer knows where it came from.
void makeMeshPathsAbsolute(XMLElement & parent, const fs::path & folder)
{
  for (XMLElement * child = parent.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (std::string(child->Name()) == "mesh") {
      XMLElement * const uri = child->FirstChildElement("uri");
      const std::string path = textOf(uri);
      std::error_code ignored;
      if (!path.empty() && path.find("://") == std::string::npos && fs::is_regular_file(folder / path, ignored)) {
        uri->SetText(("file://" + fs::absolute(folder / path).string()).c_str());
      }
    }
    makeMeshPathsAbsolute(*child, folder);
  }
}

XMLElement * readSdf(tinyxml2::XMLDocument & document, const std::string & path)
{
  if (document.LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS) {
    return nullptr;
  }
  XMLElement * const root = document.FirstChildElement("sdf");
  if (root) {
    dropSilent(*root);
    makeMeshPathsAbsolute(*root, fs::path(path).parent_path());
  }
  return root;
}

bool hasAttributes(const XMLElement * element)
{
  return element && element->FirstAttribute() != nullptr;
}

/// Whether a pose is one in the world, as it is said in every version.
bool isInWorld(const XMLElement * pose)
{
  const char * const frame = pose ? pose->Attribute("frame") : nullptr;
  return !pose || (!pose->Attribute("relative_to") && (!frame || std::string(frame).empty()));
}

bool isPlain(const XMLElement & include)
{
  static const std::set<std::string> understood{"uri", "name", "pose", "static"};
  for (auto child = include.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (understood.count(child->Name()) == 0 || hasAttributes(child)) {
      return false;
    }
  }
  return !hasAttributes(&include);
}

void overrideChild(XMLElement & model, const XMLElement & include, const char * tag)
{
  const XMLElement * const given = include.FirstChildElement(tag);
  if (!given) {
    return;
  }
  while (XMLElement * const own = model.FirstChildElement(tag)) {
    model.DeleteChild(own);
  }
  model.InsertFirstChild(given->DeepClone(model.GetDocument()));
}
}  // namespace

std::string modelFile(const std::string & uri, const UriLookup & uris)
{
  const std::string found = uris.find(uri);
  std::error_code ignored;
  if (!fs::is_directory(found, ignored)) {
    return found;
  }
  return fs::is_regular_file(fs::path(found) / "model.config", ignored) ? sdf::getModelFilePath(found) : "";
}

WorldText::WorldText(const std::string & path, const UriLookup & uris)
{
  complete_ = takeApart(path, uris);
}

bool WorldText::takeApart(const std::string & path, const UriLookup & uris)
{
  XMLElement * const root = readSdf(world_, path);
  XMLElement * const world = root ? root->FirstChildElement() : nullptr;
  if (!world || std::string(world->Name()) != "world" || world->NextSiblingElement()) {
    return false;
  }
  for (XMLElement * child = world->FirstChildElement(); child;) {
    XMLElement * const next = child->NextSiblingElement();
    const std::string tag = child->Name();
    const bool tied = tag == "frame" || tag == "joint" || !isInWorld(child->FirstChildElement("pose"));
    if (tied || (tag == "include" && !takeInclude(*child, uris))) {
      return false;
    }
    if (tag == "model") {
      models_.push_back({nameOf(child), nullptr});
    } else if (tag == "include") {
      world->DeleteChild(child);
    }
    child = next;
  }
  std::set<std::string> names;
  return std::all_of(
    models_.begin(), models_.end(), [&names](const Model & model) { return names.insert(model.name).second; });
}

bool WorldText::takeInclude(XMLElement & include, const UriLookup & uris)
{
  auto document = std::make_unique<tinyxml2::XMLDocument>();
  const std::string file = isPlain(include) ? modelFile(textOf(include.FirstChildElement("uri")), uris) : "";
  XMLElement * const root = file.empty() ? nullptr : readSdf(*document, file);
  if (!root) {
    return false;
  }
  XMLElement * const model = root->FirstChildElement();
  if (!model) {
    return true;  // a light
  }
  if (
    std::string(model->Name()) != "model" || model->NextSiblingElement() ||
    !isInWorld(model->FirstChildElement("pose"))) {
    return false;
  }
  if (const std::string name = textOf(include.FirstChildElement("name")); !name.empty()) {
    model->SetAttribute("name", name.c_str());
  }
  overrideChild(*model, include, "static");
  overrideChild(*model, include, "pose");
  models_.push_back({nameOf(model), std::move(document)});
  return true;
}

std::set<std::string> WorldText::tags() const
{
  std::set<std::string> tags = elementNames(world_);
  for (const Model & model : models_) {
    if (model.included) {
      tags.merge(elementNames(*model.included));
    }
  }
  return tags;
}

std::string printed(const tinyxml2::XMLDocument & document)
{
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}
}  // namespace f1tenth_sim2d
