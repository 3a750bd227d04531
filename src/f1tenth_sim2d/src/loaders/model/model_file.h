#pragma once

#include <string>

#include "loaders/files/uri_lookup.h"
#include "loaders/xml/element.h"

namespace f1tenth_sim2d
{
/// The file that an <include> means: that of its <uri>, or, if it is a folder, the newest in it that its model.config
/// names and that can be read here.
/// @throws LoadError
std::string modelFile(const Element & include, const UriLookup & uris);
}  // namespace f1tenth_sim2d
