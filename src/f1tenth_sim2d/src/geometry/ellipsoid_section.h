#pragma once

#include "f1tenth_sim2d/section.h"

namespace f1tenth_sim2d
{
/// Sections and footprints of ellipsoids; ellipses become polygons as in round_section.h.
Section cut(const Ellipsoid & ellipsoid, const Pose3 & pose, double z);
Section shadow(const Ellipsoid & ellipsoid, const Pose3 & pose, double z_min, double z_max);
}  // namespace f1tenth_sim2d
