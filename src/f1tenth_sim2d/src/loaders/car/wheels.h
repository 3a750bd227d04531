#pragma once

#include <vector>

#include "loaders/car/car_mechanism.h"

namespace f1tenth_sim2d
{
/// Finds radius and friction of the joints that do not steer: from the first round collision of the link, or else the
/// radius from the height of the axle.
void measureWheels(std::vector<MechanismJoint> & joints, const CarDescription & car);

/// Removes joints about the y axis that are no wheels: those that cannot turn all the way round (a tilting camera, a
/// lever), and those far above the ground on which the others stand.
void dropWhatDoesNotRoll(std::vector<MechanismJoint> & joints);
}  // namespace f1tenth_sim2d
