#pragma once

#include "f1tenth_sim2d/section.h"

/// Sections and footprints of solids with round sides. Curves that are not circles become polygons whose corners
/// lie on the curve and whose edges are within kCurveTolerance of it.
namespace f1tenth_sim2d
{
constexpr double kCurveTolerance = 5e-5;  ///< m

Section cut(const Sphere & sphere, const Pose3 & pose, double z);
Section shadow(const Sphere & sphere, const Pose3 & pose, double z_min, double z_max);
Section cut(const Cylinder & cylinder, const Pose3 & pose, double z);
Section shadow(const Cylinder & cylinder, const Pose3 & pose, double z_min, double z_max);
}  // namespace f1tenth_sim2d
