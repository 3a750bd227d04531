#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "core/contacts/piece.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Friction coefficient of the ground planes, infinite where the world has none: then that of the model decides.
double groundFriction(const WorldDescription & world);

/// Lets a movable body rub on the ground, and puts it to sleep.
/// It is a joint, so that Box2D solves friction with the ground together with the contacts: what is pushed with less
/// than friction holds stays where it is.
/// @param pieces  of the body
/// @param ground  friction coefficient of the ground
/// @param weight  N
void addFrictionJoint(
  b2Body & ground_body, b2Body & body, const std::vector<Piece> & pieces, double ground, double weight);
}  // namespace f1tenth_sim2d
