#pragma once

#include <cstdint>
#include <vector>

#include "core/models/body_state.h"

namespace f1tenth_sim2d
{
/// Appends x, y, delta, v, psi, psi_dot, beta as little-endian binary64 numbers.
void appendBytes(const BodyState & state, std::vector<std::uint8_t> & bytes);
}  // namespace f1tenth_sim2d
