#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/contacts/piece.h"
#include "core/contacts/piece_set.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// A model as a body: static ones stand in the frame of the world, movable ones have their centre of mass as origin.
struct ModelBody
{
  Pose2 frame;          ///< of the model at the start, in the world
  Vec2 centre_of_mass;  ///< m, in that frame
};

/// The convex pieces of all models of a world, worked out once, for any number of simulations on any threads.
class WorldPieces
{
public:
  /// @param world  outlives this
  explicit WorldPieces(const WorldDescription & world);

  /// Pieces of whole solids: for upright ones those of every layer, and for contacts between models.
  const PieceSet & whole() const { return *whole_; }
  /// The layer of car solids of this span; the world is cut for it at the first call.
  const PieceSet & layerFor(const Heights & span) const;
  const std::vector<ModelBody> & bodies() const { return bodies_; }

private:
  std::unique_ptr<const PieceSet> cutWhole() const;

  struct SpanLayer
  {
    Heights span;
    std::unique_ptr<const PieceSet> pieces;
  };

  const WorldDescription & world_;
  const std::vector<ModelBody> bodies_;
  const std::unique_ptr<const PieceSet> whole_;
  mutable std::mutex mutex_;  ///< guards what follows
  mutable std::vector<SpanLayer> layers_;
};
}  // namespace f1tenth_sim2d
