#include "loaders/sdf/include_cycles.h"

#include <algorithm>
#include <set>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/xml_text.h"
#include "loaders/sdf/sdf_messages.h"
#include "loaders/sdf/world_text.h"

namespace f1tenth_sim2d
{
namespace
{
class IncludeWalk
{
public:
  IncludeWalk(const std::string & world_file, const UriLookup & uris) : world_file_(world_file), uris_(uris) {}

  void enter(const std::string & file)
  {
    tinyxml2::XMLDocument document;
    if (!visited_.insert(file).second || document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) {
      return;
    }
    open_.push_back(file);
    follow(document);
    open_.pop_back();
  }

private:
  void follow(const tinyxml2::XMLNode & parent)
  {
    for (auto child = parent.FirstChildElement(); child; child = child->NextSiblingElement()) {
      if (std::string(child->Name()) == "include") {
        followInclude(modelFile(textOf(child->FirstChildElement("uri")), uris_));
      } else {
        follow(*child);
      }
    }
  }

  void followInclude(const std::string & file)
  {
    if (std::find(open_.begin(), open_.end(), file) != open_.end()) {
      throw LoadError(world_file_, "", open_.back() + " includes " + file + ", which includes it: that never ends");
    }
    if (!file.empty()) {
      enter(file);
    }
  }

  const std::string & world_file_;
  const UriLookup & uris_;
  std::vector<std::string> open_;
  std::set<std::string> visited_;
};
}  // namespace

void requireEndOfIncludes(const std::string & world_file, const UriLookup & uris)
{
  const SdfMessages messages;  // for what libsdformat says of folders without a model
  IncludeWalk(world_file, uris).enter(world_file);
}
}  // namespace f1tenth_sim2d
