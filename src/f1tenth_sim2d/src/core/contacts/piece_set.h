#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/contacts/piece.h"

namespace f1tenth_sim2d
{
/// The pieces that the models of a world have in one layer. Never changes, and does not depend on what has happened in
/// the world: pieces come in the order in which they were given, whoever asked before.
class PieceSet
{
public:
  using Range = std::pair<const Piece *, const Piece *>;

  /// @param movable  of movable models, in the order of the models, each in the frame of its body
  /// @param fixed    of static models, in the frame of the world
  PieceSet(Layer layer, std::vector<Piece> movable, std::vector<Piece> fixed);
  PieceSet(const PieceSet &) = delete;
  PieceSet & operator=(const PieceSet &) = delete;

  Layer layer() const { return layer_; }
  const std::vector<Piece> & movable() const { return movable_; }
  /// Begin and end of the pieces of a movable model.
  Range ofMovable(std::size_t model) const;
  std::size_t fixedCount() const { return fixed_.size(); }

  /// Calls visit(index, piece) for the fixed pieces whose bounds touch a region (Box2D units).
  template <typename Visit>
  void forEachFixedIn(const b2AABB & region, Visit visit) const
  {
    Query<Visit> query{*this, visit};
    tree_.Query(&query, region);
  }

private:
  template <typename Visit>
  struct Query
  {
    const PieceSet & pieces;
    Visit & visit;

    bool QueryCallback(int32 node)
    {
      const auto index = reinterpret_cast<std::uintptr_t>(pieces.tree_.GetUserData(node));
      visit(index, pieces.fixed_[index]);
      return true;
    }
  };

  const Layer layer_;
  const std::vector<Piece> movable_;
  const std::vector<Piece> fixed_;
  b2DynamicTree tree_;  // the user data of a node is the index of its fixed piece
};
}  // namespace f1tenth_sim2d
