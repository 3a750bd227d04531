#include "core/contacts/static_pieces.h"

#include <utility>

namespace f1tenth_sim2d
{
StaticPieces::StaticPieces(std::vector<Piece> pieces) : pieces_(std::move(pieces))
{
  const b2Transform in_world(b2Vec2_zero, b2Rot(0.0F));
  for (std::uintptr_t i = 0; i < pieces_.size(); ++i) {
    b2AABB bounds;
    pieces_[i].boxShape().ComputeAABB(&bounds, in_world, 0);
    tree_.CreateProxy(bounds, reinterpret_cast<void *>(i));
  }
}
}  // namespace f1tenth_sim2d
