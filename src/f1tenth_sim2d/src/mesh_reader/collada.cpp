#include "mesh_reader/collada.h"

#include <tinyxml2.h>

#include <set>

namespace f1tenth_sim2d
{
namespace
{
const std::set<std::string> kLooks{"bind_material",  "library_animations", "library_cameras",   "library_effects",
                                   "library_images", "library_lights",     "library_materials", "extra"};

void drop(tinyxml2::XMLNode & parent, bool looks)
{
  for (tinyxml2::XMLNode * child = parent.FirstChild(); child != nullptr;) {
    tinyxml2::XMLNode * const next = child->NextSibling();
    const bool is_look = looks && child->ToElement() && kLooks.count(child->Value()) > 0;
    if (is_look || child->ToComment()) {
      parent.DeleteChild(child);
    } else {
      drop(*child, looks);
    }
    child = next;
  }
}

std::string without(const std::string & bytes, bool looks)
{
  tinyxml2::XMLDocument document(true, tinyxml2::COLLAPSE_WHITESPACE);
  if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
    return bytes;
  }
  drop(document, looks);
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}
}  // namespace

std::string tidiedCollada(const std::string & bytes)
{
  return without(bytes, false);
}

std::string geometryOfCollada(const std::string & bytes)
{
  return without(bytes, true);
}
}  // namespace f1tenth_sim2d
