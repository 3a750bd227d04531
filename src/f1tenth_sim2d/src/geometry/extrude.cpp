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

bool anyMeet(const std::vector<Outline> & outlines)
{
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t j = i + 1; j < outlines.size(); ++j) {
      if (edgesMeet(outlines[i], outlines[j])) {
        return true;
      }
    }
  }
  return false;
}

/// Outlines that do not meet, those of holes turned clockwise.
std::vector<Outline> withHoles(const std::vector<Outline> & outlines)
{
  std::vector<Outline> turned = outlines;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (isHole(outlines[i], outlines)) {
      std::reverse(turned[i].begin(), turned[i].end());
    }
  }
  return turned;
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
  Polyline polyline{anyMeet(around) ? coveredOddly(around) : withHoles(around), {}, height};
  polyline.pieces = piecesOf(polyline.outlines);
  return polyline;
}
}  // namespace f1tenth_sim2d
