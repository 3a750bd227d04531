#pragma once

#include <string>

#include "loaders/files/uri_lookup.h"

namespace f1tenth_sim2d
{
/// libsdformat follows includes until the stack ends, so somebody has to look before it does.
/// @throws LoadError if a file that the world includes, directly or not, includes itself over others
void requireEndOfIncludes(const std::string & world_file, const UriLookup & uris);
}  // namespace f1tenth_sim2d
