#pragma once

#include <string>

namespace f1tenth_sim2d
{
/// Whether a path names a file that is there, and may be looked at.
bool isFile(const std::string & path);

/// The bytes of a file.
/// @throws LoadError for one that is not there, that is a folder, or that cannot be read
std::string readFile(const std::string & path);
}  // namespace f1tenth_sim2d
