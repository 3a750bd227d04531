#pragma once

#include <tinyxml2.h>

#include <string>

#include "element_reader.h"

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
}  // namespace f1tenth_sim2d
