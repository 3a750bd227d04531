#include <tinyxml2.h>

#include <algorithm>
#include <sdf/Model.hh>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "loaders/car/robot_text.h"
#include "loaders/files/uri_lookup.h"
#include "loaders/sdf/sdf_errors.h"
#include "loaders/sdf/sdf_models.h"
#include "loaders/sdf/sdf_schema.h"

namespace f1tenth_sim2d
{
namespace
{
/// Whether any element is one that only a car has.
class CarParts : public tinyxml2::XMLVisitor
{
public:
  bool VisitEnter(const tinyxml2::XMLElement & element, const tinyxml2::XMLAttribute * /*first*/) override
  {
    const std::string tag = element.Name();
    const char * const type = element.Attribute("type");
    const std::string joint_type = tag == "joint" && type != nullptr ? type : "";
    found = found || tag == "sensor" || tag == "plugin" || joint_type == "continuous" || joint_type == "revolute";
    return !found;
  }

  bool found{false};
};
}  // namespace

bool describesCar(const std::string & xml, const std::string & source)
{
  rootElement(xml, source);
  tinyxml2::XMLDocument document;
  document.Parse(xml.c_str(), xml.size());
  CarParts parts;
  document.Accept(&parts);
  return parts.found;
}

LoadedModel loadModel(
  const std::string & xml, const std::string & name, const Pose3 & pose, const std::string & source,
  const SearchPath & search_path)
{
  const SdfMessages messages;
  const std::string kind = rootElement(xml, source);
  if (kind != "robot" && kind != "sdf") {
    throw LoadError(source, kind, "is no model, allowed are <robot> (URDF) and <sdf>");
  }
  const UriLookup uris(search_path, "");
  WarningCollector warnings;
  sdf::Root root;
  sdf::ParserConfig config = parserConfig();
  config.SetFindCallback([&uris](const std::string & uri) { return uris.find(uri); });
  const sdf::Errors errors = loadText(xml, config, root);
  checkSdfErrors(errors, messages, root, source, "; searched: " + uris.searchedFolders(), warnings);
  const sdf::Model * const model = root.Model();
  if (!model) {
    throw LoadError(source, "", "holds no <model>");
  }
  sdf::Model renamed = *model;
  renamed.SetName(name);
  MeshLibrary meshes(uris, warnings);
  LoadedModel loaded;
  appendModel(renamed, pose, source, meshes, loaded.models, warnings);
  loaded.warnings = warnings.messages();
  return loaded;
}
}  // namespace f1tenth_sim2d
