#include <algorithm>

#include "f1tenth_sim2d/section.h"
#include "geometry/planar.h"
#include "geometry/polygon_union.h"

namespace f1tenth_sim2d
{
namespace
{
bool isHole(const Outline & outline, const std::vector<Outline> & all)
{
  const auto around = std::count_if(all.begin(), all.end(), [&outline](const Outline & other) {
    return &other != &outline && contains(other, outline.front());
  });
  return around % 2 == 1;
}

std::vector<ConvexPolygon> piecesOf(const std::vector<Outline> & outlines)
{
  if (outlines.size() == 1) {
    return convexDecomposition(outlines.front());
  }
  PolygonUnion area;
  area.add(outlines);
  return area.convexPieces();
}
}  // namespace

Polyline extrude(const std::vector<Outline> & outlines, double height)
{
  std::vector<Outline> around;
  for (const Outline & outline : outlines) {
    if (Outline corners = withoutRedundantCorners(outline); !corners.empty()) {
      around.push_back(std::move(corners));
    }
  }
  Polyline polyline{around, {}, height};
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (isHole(around[i], around)) {
      std::reverse(polyline.outlines[i].begin(), polyline.outlines[i].end());
    }
  }
  polyline.pieces = piecesOf(polyline.outlines);
  return polyline;
}
}  // namespace f1tenth_sim2d
