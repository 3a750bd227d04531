#pragma once

#include <vector>

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// A circle of a section or footprint, kept exactly instead of as a polygon; m.
struct Circle
{
  Vec2 centre;
  double radius{0.0};
};

/// Where a horizontal plane cuts solids.
struct Section
{
  std::vector<Outline> outlines;
  std::vector<Circle> circles;
};

/// Cross-section of a solid at height z, m: what a level lidar at that height sees.
/// @param pose  of the solid in the frame in which z and the result are given
/// A Plane has no section.
Section sectionAt(const Solid & solid, const Pose3 & pose, double z);
/// The same for several solids, whose poses are relative to a frame.
Section sectionAt(const std::vector<Solid> & solids, const Pose3 & frame, double z);
/// The same for the static models of a world.
Section staticSectionAt(const WorldDescription & world, double z);

/// Shadow on the ground of the part of a solid between z_min and z_max, m: what a body of that vertical span touches.
/// Convex pieces; outlines that are not convex are decomposed.
Section footprintBetween(const Solid & solid, const Pose3 & pose, double z_min, double z_max);

/// The area enclosed by an odd number of outlines, extruded along z: an outline within another one is a hole in it, one
/// within a hole is solid again. Corners on the line through their neighbours are dropped; those of outlines that meet
/// are rounded to 0.1 micrometres.
Polyline extrude(const std::vector<Outline> & outlines, double height);

/// Splits a simple outline into convex polygons (their union is the outline).
std::vector<ConvexPolygon> convexDecomposition(const Outline & outline);
}  // namespace f1tenth_sim2d
