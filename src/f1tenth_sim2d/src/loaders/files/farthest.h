#pragma once

namespace f1tenth_sim2d
{
/// m, from the origin of the world or of a mesh, and of lengths: more is a mistake, and numbers would lose the
/// precision that sections need.
constexpr double kFarthest = 1e5;
}  // namespace f1tenth_sim2d
