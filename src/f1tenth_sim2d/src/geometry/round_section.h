#pragma once

#include "f1tenth_sim2d/section.h"

/// Sections and footprints of solids with round sides. Curves that are not circles become polygons whose corners
/// lie on the curve and whose edges are within kCurveTolerance of it; a cylinder that leans, a prism over such a polygon:
/// its sections lie within kCurveTolerance of its surface, and end as much below the top of one that lies.
namespace f1tenth_sim2d
{
constexpr double kCurveTolerance = 5e-5;  ///< m

Section cut(const Sphere & sphere, const Pose3 & pose, double z);
Section shadow(const Sphere & sphere, const Pose3 & pose, double z_min, double z_max);
Section cut(const Cylinder & cylinder, const Pose3 & pose, double z);
Section shadow(const Cylinder & cylinder, const Pose3 & pose, double z_min, double z_max);
Section cut(const Capsule & capsule, const Pose3 & pose, double z);
Section shadow(const Capsule & capsule, const Pose3 & pose, double z_min, double z_max);
Section cut(const Ellipsoid & ellipsoid, const Pose3 & pose, double z);
Section shadow(const Ellipsoid & ellipsoid, const Pose3 & pose, double z_min, double z_max);

/// Steps of an arc, rad, of a curve with this greatest radius, m, so that no chord is off by more than the tolerance.
int curveSteps(double arc, double greatest_radius);
}  // namespace f1tenth_sim2d
