#pragma once

#include "loaders/model/model.h"
#include "loaders/shapes/mesh_library.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// Fills in a link of an SDF model, whose element and name are known.
/// @param frames  of the model, all of them
/// @throws LoadError
void readLink(LinkPart & link, const FrameScope & frames, MeshLibrary & meshes, WarningCollector & warnings);

/// The same for a joint.
void readJoint(JointPart & joint, const FrameScope & frames);

/// Friction and bounce of a <surface>.
void readSurface(const Element & surface, Solid & solid, WarningCollector & warnings);

/// A coefficient of friction; less than 0 means infinite, as in Gazebo.
double frictionOf(const Element & element, double mu, WarningCollector & warnings);

/// Warns of an inertia that no body has. Only mass and yaw inertia of what moves matter; they are checked later.
void warnOfInertia(const Element & place, const Inertia & inertia, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
