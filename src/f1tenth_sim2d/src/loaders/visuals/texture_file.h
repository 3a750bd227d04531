#pragma once

#include <memory>
#include <string>

#include "render/texture.h"

namespace f1tenth_sim2d
{
/// A PNG, JPEG or other image as a texture; one that is in use is not read again. From any thread.
/// @throws Error for a file that is not there, that is broken or too large
std::shared_ptr<const Texture> readTexture(const std::string & path);
}  // namespace f1tenth_sim2d
