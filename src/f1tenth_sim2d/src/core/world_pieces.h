#pragma once

#include <cstddef>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "piece.h"

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
  const std::vector<Piece> & ofWholeSolids() const { return whole_solids_; }
  const std::vector<Piece> & ofLayer(std::size_t layer) const { return layers_[layer]; }
  const std::vector<ModelBody> & bodies() const { return bodies_; }

private:
  const WorldDescription & world_;
  std::vector<ModelBody> bodies_;
  std::vector<Piece> whole_solids_;
  std::vector<VerticalSpan> spans_;
  std::vector<std::vector<Piece>> layers_;
};

/// The pieces of a car about its centre of mass.
/// @param centre_of_mass  m, in front of base_footprint
std::vector<Piece> carPieces(
  const std::vector<Solid> & solids, double centre_of_mass, std::uint32_t car, WorldPieces & world);
}  // namespace f1tenth_sim2d
