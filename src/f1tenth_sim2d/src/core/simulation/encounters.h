#pragma once

#include "core/contacts/collision_world.h"
#include "core/simulation/registered_car.h"

/// Which cars are near anything that they could touch: only those take part in the rigid-body world.
///
/// Each car keeps a distance that it may go before it has to look again: what was free around it when it last looked,
/// less what it and everything else that moves may have travelled since. Far from everything a step costs one
/// subtraction per car.
namespace f1tenth_sim2d
{
/// All cars look again before the next step: something was put somewhere.
void forgetSurroundings(const Cars & cars) noexcept;

/// Applies contacts to the predicted motion of all cars in a step of dt seconds.
/// @param spares_far_cars  see SimulationOptions
/// @return whether the rigid-body world was advanced
bool applyContacts(const Cars & cars, CollisionWorld & world, double dt, bool spares_far_cars);
}  // namespace f1tenth_sim2d
