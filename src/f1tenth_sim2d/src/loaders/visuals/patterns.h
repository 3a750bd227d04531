#pragma once

#include <memory>

#include "render/texture.h"

namespace f1tenth_sim2d
{
/// A grey texture that this project draws itself, to be multiplied by a colour.
enum class Pattern
{
  kNone,
  kBricks,
  kPlanks,
  kTiles,
  kSpeckles
};

constexpr double kPatternSide = 1.0;  ///< m, that a pattern covers before it repeats itself

/// Null for kNone; drawn once.
std::shared_ptr<const Texture> textureOf(Pattern pattern);
}  // namespace f1tenth_sim2d
