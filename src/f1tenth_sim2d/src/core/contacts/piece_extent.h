#pragma once

#include <vector>

#include "core/contacts/piece.h"

namespace f1tenth_sim2d
{
/// Radius of the circle about the origin of the body that holds all pieces, m.
double outerRadius(const std::vector<Piece> & pieces);

/// Mean distance of the pieces' area from the origin of the body, m: the lever of friction with the ground.
double meanRadius(const std::vector<Piece> & pieces);
}  // namespace f1tenth_sim2d
