#include "geometry/planar.h"

#include <algorithm>
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/algorithms/within.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/register/multi_point.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>

BOOST_GEOMETRY_REGISTER_POINT_2D(f1tenth_sim2d::Vec2, double, boost::geometry::cs::cartesian, x, y)
BOOST_GEOMETRY_REGISTER_MULTI_POINT(std::vector<f1tenth_sim2d::Vec2>)

namespace f1tenth_sim2d
{
namespace
{
/// Counter-clockwise, without its closing corner.
using Ring = boost::geometry::model::ring<Vec2, false, false>;

using Line = boost::geometry::model::linestring<Vec2>;

/// Whether b adds nothing to the line from a to c: on it, a spike, or a copy of a neighbour.
bool isRedundant(const Vec2 & a, const Vec2 & b, const Vec2 & c)
{
  const double longest_side = std::max({distance(a, b), distance(b, c), distance(a, c)});
  return std::abs(turn(a, b, c)) <= kTolerance * longest_side;
}
}  // namespace

double turn(const Vec2 & a, const Vec2 & b, const Vec2 & c)
{
  return cross(b - a, c - a);
}

double signedArea(const Outline & outline)
{
  double doubled = 0.0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    doubled += turn(outline[0], outline[i], outline[i + 1]);
  }
  return doubled / 2.0;
}

Outline withoutRedundantCorners(Outline outline)
{
  if (signedArea(outline) < 0.0) {
    std::reverse(outline.begin(), outline.end());
  }
  std::size_t kept_in_a_row = 0;
  std::size_t i = 0;
  while (outline.size() >= 3 && kept_in_a_row < outline.size()) {
    const std::size_t n = outline.size();
    i %= n;
    if (isRedundant(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n])) {
      outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
      kept_in_a_row = 0;
      i += n - 2;  // the corner before may have become redundant
    } else {
      ++kept_in_a_row;
      ++i;
    }
  }
  return outline.size() >= 3 ? outline : Outline{};
}

bool isSimple(const Outline & outline)
{
  const Outline corners = withoutRedundantCorners(outline);
  return !corners.empty() && boost::geometry::is_valid(Ring(corners.begin(), corners.end()));
}

bool edgesMeet(const Outline & a, const Outline & b)
{
  const auto edges = [](const Outline & outline) {
    Line line(outline.begin(), outline.end());
    line.push_back(outline.front());
    return line;
  };
  return boost::geometry::intersects(edges(a), edges(b));
}

bool contains(const Outline & outline, const Vec2 & point)
{
  return boost::geometry::within(point, Ring(outline.begin(), outline.end()));
}

ConvexPolygon convexHull(const std::vector<Vec2> & points)
{
  if (points.size() < 3) {
    return {};
  }
  Ring hull;
  boost::geometry::convex_hull(points, hull);
  return withoutRedundantCorners({hull.begin(), hull.end()});
}
}  // namespace f1tenth_sim2d
