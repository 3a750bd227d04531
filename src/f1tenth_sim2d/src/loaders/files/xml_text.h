#pragma once

#include <tinyxml2.h>

#include <set>
#include <string>

#include "loaders/sdf/element_reader.h"

namespace f1tenth_sim2d
{
/// Text of an element without the blanks around it; empty if there is no element or no text.
inline std::string textOf(const tinyxml2::XMLElement * element)
{
  return element && element->GetText() ? withoutBlanksAround(element->GetText()) : "";
}

/// Attribute `name` of an element; empty if there is none.
inline std::string nameOf(const tinyxml2::XMLElement * element)
{
  const char * const name = element ? element->Attribute("name") : nullptr;
  return name ? name : "";
}

/// Names of all elements below a node.
inline std::set<std::string> elementNames(const tinyxml2::XMLNode & node)
{
  std::set<std::string> tags;
  for (auto child = node.FirstChildElement(); child; child = child->NextSiblingElement()) {
    tags.insert(child->Name());
    tags.merge(elementNames(*child));
  }
  return tags;
}
}  // namespace f1tenth_sim2d
