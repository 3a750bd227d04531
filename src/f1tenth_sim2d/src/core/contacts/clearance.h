#pragma once

#include <vector>

#include "core/contacts/car_body.h"
#include "core/contacts/collision_world.h"

namespace f1tenth_sim2d
{
/// A car at a place.
struct PlacedCar
{
  const CarBody & body;
  Pose2 pose;  ///< of the centre of mass
};

/// Least distance from a car to anything it could touch, m; 0 in contact; at most limit.
/// @param own  index of the car in cars
double clearance(const std::vector<PlacedCar> & cars, std::size_t own, const CollisionWorld & world, double limit);

/// The piece that overlaps a car, or nullptr; of several the first by owner, body and solid.
const Piece * firstOverlap(const std::vector<PlacedCar> & cars, std::size_t own, const CollisionWorld & world);
}  // namespace f1tenth_sim2d
