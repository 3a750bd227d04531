#pragma once

#include "geometry/planar.h"

namespace f1tenth_sim2d
{
/// Whether a polygon has three corners or more and turns left at each of them.
inline bool isConvex(const Outline & polygon)
{
  bool convex = polygon.size() >= 3;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    convex = convex && turn(polygon[i], polygon[(i + 1) % polygon.size()], polygon[(i + 2) % polygon.size()]) > 0.0;
  }
  return convex;
}

/// Sum of the areas of polygons, m^2.
inline double areaOf(const std::vector<Outline> & polygons)
{
  double sum = 0.0;
  for (const Outline & polygon : polygons) {
    sum += signedArea(polygon);
  }
  return sum;
}
}  // namespace f1tenth_sim2d
