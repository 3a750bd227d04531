#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <vector>

#include "core/contacts/contact_log.h"
#include "core/contacts/piece.h"
#include "core/contacts/piece_set.h"
#include "core/contacts/world_pieces.h"
#include "core/math/planar_motion.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// A body of Box2D that moves.
struct Participant
{
  b2Body * body{nullptr};
  double outer_radius{0.0};            ///< m
  std::optional<b2AABB> surroundings;  ///< in which Box2D has the static pieces
};

/// A car as a rigid body, and what its CollisionWorld keeps about it.
struct CarBody
{
  /// @param centre_of_mass  m, in front of base_footprint
  /// @param body_mass       kg
  /// @param body_inertia    kg m^2, about the centre of mass
  CarBody(
    CarId id, const std::vector<Solid> & solids, double centre_of_mass, double body_mass, double body_inertia,
    const WorldPieces & world);

  std::vector<Piece> pieces;             ///< about the centre of mass
  std::vector<const PieceSet *> layers;  ///< of the world, to which these pieces belong
  double mass;                           ///< kg
  double inertia;                        ///< kg m^2

  Participant participant;
  PlanarMotion placed;                ///< in the last step in which it took part
  std::vector<StepContact> contacts;  ///< of the last step
};
}  // namespace f1tenth_sim2d
