#pragma once

#include <cstddef>
#include <vector>

#include "core/contacts/piece.h"
#include "core/contacts/static_pieces.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// A model as a body: static ones stand in the frame of the world, movable ones have their centre of mass as origin.
struct ModelBody
{
  Pose2 frame;          ///< of the model at the start, in the world
  Vec2 centre_of_mass;  ///< m, in that frame
};

/// The convex pieces of all models of a world, worked out once.
class WorldPieces
{
public:
  explicit WorldPieces(const WorldDescription & world);

  /// The layer of car solids of this span; the world is cut for it at the first time.
  Layer layerFor(const VerticalSpan & span);

  std::size_t layerCount() const { return spans_.size(); }
  /// Of movable models.
  const std::vector<Piece> & ofWholeSolids() const { return whole_solids_.movable; }
  const std::vector<Piece> & ofLayer(std::size_t layer) const { return layers_[layer].movable; }
  /// Of static models, all layers.
  const StaticPieces & statics() const { return statics_; }
  const std::vector<ModelBody> & bodies() const { return bodies_; }

private:
  struct Pieces
  {
    std::vector<Piece> movable;
    std::vector<Piece> fixed;
  };

  std::vector<Piece> & of(Pieces & pieces, const Piece & properties) const;
  void addStatics(const Pieces & pieces);

  const WorldDescription & world_;
  std::vector<ModelBody> bodies_;
  Pieces whole_solids_;
  std::vector<VerticalSpan> spans_;
  std::vector<Pieces> layers_;
  StaticPieces statics_;
};

/// The pieces of a car about its centre of mass.
/// @param centre_of_mass  m, in front of base_footprint
std::vector<Piece> carPieces(
  const std::vector<Solid> & solids, double centre_of_mass, std::uint32_t car, WorldPieces & world);
}  // namespace f1tenth_sim2d
