#include "core/contacts/piece_set.h"

#include <algorithm>

namespace f1tenth_sim2d
{
PieceSet::PieceSet(Layer layer, std::vector<Piece> movable, std::vector<Piece> fixed)
: layer_(layer), movable_(std::move(movable)), fixed_(std::move(fixed))
{
  const b2Transform in_world(b2Vec2_zero, b2Rot(0.0F));
  for (std::uintptr_t i = 0; i < fixed_.size(); ++i) {
    b2AABB bounds;
    fixed_[i].boxShape().ComputeAABB(&bounds, in_world, 0);
    tree_.CreateProxy(bounds, reinterpret_cast<void *>(i));
  }
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
