#include "f1tenth_sim2d/loaders.h"
#include "loaders/model/model_reader.h"
#include "loaders/world/describe_model.h"

namespace f1tenth_sim2d
{
namespace
{
bool hasCarParts(const Element & parent)
{
  for (const Element & child : parent.children()) {
    const std::string type = child.is("joint") ? child.attribute("type") : "";
    const bool turns = type == "continuous" || type == "revolute";
    if (turns || child.is("sensor") || child.is("plugin") || hasCarParts(child)) {
      return true;
    }
  }
  return false;
}
}  // namespace

bool describesCar(const std::string & xml, const std::string & source)
{
  WarningCollector ignored;
  return hasCarParts(XmlDocuments(ignored).readText(xml, source));
}

LoadedModel loadModel(
  const std::string & xml, const std::string & name, const Pose3 & pose, const std::string & source,
  const SearchPath & search_path)
{
  const UriLookup uris(search_path, "");
  WarningCollector warnings;
  ModelReader reader(uris, warnings);
  Model model = reader.readText(xml, source, "model");
  model.name = name;
  LoadedModel loaded;
  appendModel(model, pose * ownPose(model), loaded.models, warnings);
  loaded.warnings = warnings.messages();
  return loaded;
}
}  // namespace f1tenth_sim2d
