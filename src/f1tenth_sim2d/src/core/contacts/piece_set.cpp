#include "core/contacts/piece_set.h"

#include <algorithm>

namespace f1tenth_sim2d
{
PieceSet::PieceSet(Layer layer, CutPieces pieces)
: layer_(layer), movable_(std::move(pieces.movable)), fixed_(std::move(pieces.fixed))
{
}

PieceSet::Range PieceSet::ofMovable(std::size_t model) const
{
  const auto first =
    std::partition_point(movable_.begin(), movable_.end(), [model](const Piece & piece) { return piece.body < model; });
  const auto end =
    std::partition_point(first, movable_.end(), [model](const Piece & piece) { return piece.body == model; });
  return {movable_.data() + (first - movable_.begin()), movable_.data() + (end - movable_.begin())};
}
}  // namespace f1tenth_sim2d
