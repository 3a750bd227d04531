#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/contacts/piece.h"
#include "core/contacts/static_pieces.h"

namespace f1tenth_sim2d
{
struct CutPieces
{
  std::vector<Piece> movable;  ///< of movable models, in the order of the models, each in the frame of its body
  std::vector<Piece> fixed;    ///< of static models, in the frame of the world
};

/// The pieces that the models of a world have in one layer. Never changes.
class PieceSet
{
public:
  using Range = std::pair<const Piece *, const Piece *>;

  PieceSet(Layer layer, CutPieces pieces);

  Layer layer() const { return layer_; }
  const std::vector<Piece> & movable() const { return movable_; }
  /// First and end of the pieces of a movable model.
  Range ofMovable(std::size_t model) const;
  const StaticPieces & fixed() const { return fixed_; }

private:
  const Layer layer_;
  const std::vector<Piece> movable_;
  const StaticPieces fixed_;
};
}  // namespace f1tenth_sim2d
