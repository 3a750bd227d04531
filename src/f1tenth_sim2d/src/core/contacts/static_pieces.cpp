#include "core/contacts/static_pieces.h"

namespace f1tenth_sim2d
{
void StaticPieces::add(const Piece & piece)
{
  const b2Transform in_world(b2Vec2_zero, b2Rot(0.0F));
  b2AABB bounds;
  piece.boxShape().ComputeAABB(&bounds, in_world, 0);
  tree_.CreateProxy(bounds, reinterpret_cast<void *>(std::uintptr_t{pieces_.size()}));
  pieces_.push_back(&piece);
}
}  // namespace f1tenth_sim2d
