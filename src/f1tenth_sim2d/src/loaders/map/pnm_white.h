#pragma once

#include <string>

namespace f1tenth_sim2d
{
/// The greatest value that the pixels of a PBM, PGM or PPM file have, where it is below 255, which is then written in its
/// place: Leptonica takes few others. Else 255.
/// @param bytes  the whole file
/// @throws LoadError for a file that does not name such a value
unsigned takeWhite(const std::string & path, std::string & bytes);
}  // namespace f1tenth_sim2d
