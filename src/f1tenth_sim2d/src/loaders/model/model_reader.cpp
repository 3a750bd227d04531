#include "loaders/model/model_reader.h"

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <filesystem>
#include <set>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"
#include "loaders/frames/read_pose.h"
#include "loaders/model/known_tags.h"
#include "loaders/model/sdf_parts.h"
#include "loaders/model/urdf_model.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

const char * const kTaken = "this name is taken; names are unique among the elements of one parent";

/// A name that no element of the same tag has.
std::string newName(const Element & element, std::set<std::string> & names)
{
  const std::string name = element.requiredAttribute("name");
  if (!names.insert(name).second) {
    element.fail(kTaken);
  }
  return name;
}

void checkReserved(const Element & element, WarningCollector & warnings)
{
  if (element.name() == "world") {
    warnings.add("the name 'world' is reserved for the world itself", element.fileLine());
  }
}

/// @param what  the document should be
void requireModelDocument(const Element & root, const std::string & what)
{
  if (!root.is("robot") && !root.is("sdf")) {
    root.fail("is no " + what + ", allowed are <robot> (URDF) and <sdf>");
  }
}

/// Name of the file that a model.config gives; of several versions the newest that can be read here.
std::string newestFile(const fs::path & config)
{
  tinyxml2::XMLDocument document;
  document.LoadFile(config.c_str());
  const tinyxml2::XMLElement * const model = document.FirstChildElement("model");
  std::string newest;
  int best = -1;
  for (auto sdf = model ? model->FirstChildElement("sdf") : nullptr; sdf; sdf = sdf->NextSiblingElement("sdf")) {
    const char * const text = sdf->Attribute("version");
    const int version = text ? versionIn(text) : 0;
    if (sdf->GetText() && version > best && version <= kNewestSdfVersion) {
      best = version;
      newest = boost::algorithm::trim_copy(std::string(sdf->GetText()));
    }
  }
  return newest;
}

/// The file that an <include> refers to: that of its <uri>, or, if it is a folder, the newest in it that its
/// model.config names and that can be read here.
/// @throws LoadError
std::string modelFile(const Element & include, const UriLookup & uris)
{
  include.requiredText("uri");
  const Element uri = include.child("uri");
  const std::string found = uris.findFrom(include.document().folder, uri.text());
  if (found.empty()) {
    uri.fail("Unable to find uri[" + uri.text() + "]; searched: " + uris.searchedFolders());
  }
  if (isFile(found)) {
    return found;
  }
  // The older name is deprecated, but read by Gazebo.
  const fs::path usual = fs::path(found) / "model.config";
  const fs::path config = isFile(usual) ? usual : fs::path(found) / "manifest.xml";
  if (!isFile(config)) {
    uri.fail("uri[" + uri.text() + "] is the folder " + found + ", which holds no model.config");
  }
  const std::string name = newestFile(config);
  const fs::path file = fs::path(found) / name;
  if (name.empty() || !isFile(file)) {
    uri.fail(
      "uri[" + uri.text() +
      "]: " + (name.empty() ? config.string() + " names no <sdf> file" : file.string() + " is not there"));
  }
  return file.string();
}

/// One file may have many paths.
std::string canonical(const std::string & file)
{
  std::error_code error;
  const fs::path path = fs::weakly_canonical(file, error);
  return error ? file : path.string();
}

/// Worlds include lights, which are not needed here: no warning for these.
void warnOfNoModel(const Element & root, const Element & include, WarningCollector & warnings)
{
  const std::vector<Element> children = root.children();
  const auto is_light = [](const Element & child) { return child.is("light"); };
  if (children.empty() || !std::all_of(children.begin(), children.end(), is_light)) {
    warnings.add("the file that it includes holds no <model>: left out", include.fileLine());
  }
}
}  // namespace

Model ModelReader::readText(const std::string & xml, const std::string & source, const std::string & what)
{
  const Element root = documents_.readText(xml, source);
  requireModelDocument(root, what);
  std::optional<Model> model = readDocument(root);
  if (!model) {
    throw LoadError(source, "", "holds no <model>");
  }
  return std::move(*model);
}

std::optional<Model> ModelReader::readDocument(const Element & root)
{
  if (root.is("robot")) {
    return readUrdf(root, meshes_, warnings_);
  }
  requireSdfVersion(root, warnings_);
  const std::vector<Element> models = root.children("model");
  if (models.size() > 1) {
    warnings_.add("a second model of a document is left out", models[1].fileLine());
  }
  return models.empty() ? std::nullopt : std::optional<Model>(readModel(models.front()));
}

Model ModelReader::readModel(const Element & element)
{
  Model model;
  model.element = element;
  model.name = element.requiredAttribute("name");
  model.is_static = element.flag("static", false);
  model.given_pose = readPose(element, "");
  model.placement_frame = element.attribute("placement_frame");
  model.plugins = element.children("plugin");
  warnOfChildren(element, warnings_);
  readChildren(element, model);
  for (LinkPart & link : model.links) {
    readLink(link, *model.frames, meshes_, warnings_);
    model.link_poses[link.name] = link.pose;
  }
  for (JointPart & joint : model.joints) {
    readJoint(joint, *model.frames);
  }
  for (Model & nested : model.models) {
    nested.pose = model.frames->poseOf(nested.name, nested.element);
  }
  model.root_link = model.links.empty() ? "" : model.links.front().name;
  return model;
}

/// Names and frames of all children: what poses may be relative to.
void ModelReader::readChildren(const Element & element, Model & model)
{
  for (const Element & child : element.children()) {
    if (std::optional<Model> nested = readNested(child)) {
      nestFrames(*nested, *model.frames, warnings_);
      model.models.push_back(std::move(*nested));
    }
  }
  std::set<std::string> links;
  for (const Element & child : element.children("link")) {
    model.links.push_back({child, newName(child, links)});
    model.frames->add(child.name(), readPose(child, ""));
  }
  std::set<std::string> joints;
  for (const Element & child : element.children("joint")) {
    model.joints.push_back({child, newName(child, joints)});
    checkReserved(child, warnings_);
    model.frames->add(child.name(), readPose(child, child.child("child").text()));
  }
  for (const Element & child : element.children("frame")) {
    model.frames->add(child.requiredAttribute("name"), readPose(child, child.attribute("attached_to")));
  }
}

std::optional<Model> ModelReader::readNested(const Element & element)
{
  if (element.is("include")) {
    return readInclude(element);
  }
  return element.is("model") ? std::optional<Model>(readModel(element)) : std::nullopt;
}

std::optional<Model> ModelReader::readInclude(const Element & include)
{
  const std::string file = includedFile(include);
  const Element root = documents_.readFile(file, include);
  requireModelDocument(root, "model");
  open_files_.push_back(canonical(file));
  std::optional<Model> model = readDocument(root);
  open_files_.pop_back();
  if (!model) {
    warnOfNoModel(root, include, warnings_);
    return std::nullopt;
  }
  model->include = include;
  model->name = include.textOf("name", model->name);
  model->is_static = include.flag("static", model->is_static);
  if (include.child("pose")) {
    model->given_pose = readPose(include, "");
    model->placement_frame = include.textOf("placement_frame", model->placement_frame);
  } else if (include.child("placement_frame")) {
    include.fail("has a <placement_frame>, which needs a <pose>");
  }
  const std::vector<Element> plugins = include.children("plugin");
  model->plugins.insert(model->plugins.end(), plugins.begin(), plugins.end());
  return model;
}

std::string ModelReader::includedFile(const Element & include) const
{
  const std::string file = modelFile(include, uris_);
  if (std::find(open_files_.begin(), open_files_.end(), canonical(file)) != open_files_.end()) {
    include.fail("includes " + file + ", which includes it: that never ends");
  }
  return file;
}
}  // namespace f1tenth_sim2d
