#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/contacts/piece.h"

namespace f1tenth_sim2d
{
/// Pieces that never move, found by where they are. Nothing in here depends on what has happened in the world: pieces
/// come in the order in which they were given, whoever asked before.
class StaticPieces
{
public:
  /// @param pieces  in the frame of the world
  explicit StaticPieces(std::vector<Piece> pieces);
  StaticPieces(const StaticPieces &) = delete;
  StaticPieces & operator=(const StaticPieces &) = delete;

  std::size_t size() const { return pieces_.size(); }

  /// Calls visit(index, piece) for the pieces whose bounds touch a region (Box2D units).
  template <typename Visit>
  void forEachIn(const b2AABB & region, Visit visit) const
  {
    Query<Visit> query{*this, visit};
    tree_.Query(&query, region);
  }

private:
  template <typename Visit>
  struct Query
  {
    const StaticPieces & statics;
    Visit & visit;

    bool QueryCallback(int32 node)
    {
      const auto index = reinterpret_cast<std::uintptr_t>(statics.tree_.GetUserData(node));
      visit(index, statics.pieces_[index]);
      return true;
    }
  };

  const std::vector<Piece> pieces_;
  b2DynamicTree tree_;  // the user data of a node is the index of its piece
};
}  // namespace f1tenth_sim2d
