#pragma once

#include <string>

namespace f1tenth_sim2d
{
/// The text of a COLLADA file as Assimp can read it: without comments, and without blanks around texts. What is no XML
/// stays as it is.
std::string tidiedCollada(const std::string & bytes);

/// The same without all that tells how something looks: the geometry is read even if that cannot be.
std::string geometryOfCollada(const std::string & bytes);
}  // namespace f1tenth_sim2d
