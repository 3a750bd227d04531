#pragma once

#include <array>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// An area that grows by outlines, with holes where they leave any. Corners are kept to 0.1 micrometres.
/// All throw Error for a corner farther than 1e11 m from the origin.
class PolygonUnion
{
public:
  /// Adds what the outlines together enclose: clockwise ones take away from counter-clockwise ones.
  void add(const std::vector<Outline> & outlines);

  /// Adds areas whose outlines are counter-clockwise, many of them in little time if neighbours follow one another.
  void addEach(const std::vector<Outline> & areas);

  /// Adds strips of the given width, m, along segments neither side of which is covered: sheets seen from above.
  void addUncovered(const std::vector<std::array<Vec2, 2>> & segments, double width);

  /// The area in convex pieces. Edges are within 0.05 mm of the area's.
  std::vector<ConvexPolygon> convexPieces() const;

private:
  std::vector<Outline> outlines_;  ///< of the area so far: no two cross, holes are clockwise
};

/// What an odd number of outlines enclose, as outlines that do not cross; holes are clockwise.
std::vector<Outline> coveredOddly(const std::vector<Outline> & outlines);
}  // namespace f1tenth_sim2d
