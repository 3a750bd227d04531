#pragma once

#include "f1tenth_sim2d/section.h"

namespace f1tenth_sim2d
{
/// Cut of a surface at height z, m. What it encloses has a counter-clockwise outline, hollows in it a clockwise one; an
/// open surface, a sheet, is an outline that goes there and back, and so is a closed one whose outside is within, like
/// a room: it is seen from both sides.
/// A surface owns its lowest height, but not its highest one.
Section cut(const TriangleMesh & mesh, const Pose3 & pose, double z);

/// Shadow on the ground of the solid part between two heights; upright sheets are 1 mm thick there.
Section shadow(const TriangleMesh & mesh, const Pose3 & pose, double z_min, double z_max);
}  // namespace f1tenth_sim2d
