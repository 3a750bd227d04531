#pragma once

#include <utility>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// A convex polyhedron: corners in m and the edges between them. Whatever has flat faces is made of these.
struct ConvexBody
{
  std::vector<Eigen::Vector3d> corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

/// The upright prism over base between z_min and z_max, put at pose.
ConvexBody prism(const ConvexPolygon & base, double z_min, double z_max, const Pose3 & pose);

/// Points whose convex hull is the cut of a body at height z; none where it has no area. A body owns its lowest height,
/// but not its highest one: of two bodies that stand on each other exactly one is cut at their common height.
std::vector<Vec2> cutPoints(const ConvexBody & body, double z);

/// Points whose convex hull is the shadow on the ground of the part between two heights; none if the body only touches
/// one of them.
std::vector<Vec2> shadowPoints(const ConvexBody & body, double z_min, double z_max);
}  // namespace f1tenth_sim2d
