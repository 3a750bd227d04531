#pragma once

#include "node/gazebo_api/gazebo_entities.h"

namespace f1tenth_sim2d
{
/// How far a model has to be lifted so that its frame is at a height, m. As in Gazebo, the ground pushes one that can
/// move and is partly in it out of it. Less than a millimetre counts as nothing, for lifting is expensive.
double liftOf(const ModelDescription & model, double z);

/// Warns of a pose that would tilt a model otherwise than it is: that is not simulated.
void warnOfTilt(const Entity & model, const Pose3 & wanted);

/// A car that is put above the ground falls onto it at once; below it there is nothing.
/// @throws Error for a pose below the ground
void requireAboveGround(const Entity & car, const Pose3 & wanted);
}  // namespace f1tenth_sim2d
