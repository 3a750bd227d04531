#include "geometry/polygon_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "f1tenth_sim2d/section.h"
#include "geometry/planar.h"

namespace f1tenth_sim2d
{
namespace
{
namespace clip = ClipperLib;

constexpr double kUnitsPerMetre = 1e7;
/// Corners nearer than this to the line through their neighbours are dropped, m.
constexpr double kCleaningDistance = 2e-5;

clip::Path toPath(const Outline & outline)
{
  clip::Path path;
  for (const Vec2 & corner : outline) {
    path.emplace_back(std::llround(corner.x * kUnitsPerMetre), std::llround(corner.y * kUnitsPerMetre));
  }
  return path;
}

Outline toOutline(const clip::Path & path)
{
  Outline outline;
  for (const clip::IntPoint & point : path) {
    outline.push_back({static_cast<double>(point.X) / kUnitsPerMetre, static_cast<double>(point.Y) / kUnitsPerMetre});
  }
  return outline;
}

clip::Paths toPaths(const std::vector<Outline> & outlines)
{
  clip::Paths paths;
  for (const Outline & outline : outlines) {
    paths.push_back(toPath(outline));
  }
  return paths;
}

clip::Paths unite(const clip::Paths & paths, clip::PolyFillType filled)
{
  clip::Clipper clipper;
  clipper.AddPaths(paths, clip::ptSubject, true);
  clip::Paths united;
  clipper.Execute(clip::ctUnion, united, filled);
  return united;
}

bool covers(const clip::Paths & paths, const Vec2 & point)
{
  const clip::IntPoint where = toPath({point}).front();
  return std::count_if(
           paths.begin(), paths.end(),
           [&where](const clip::Path & path) { return clip::PointInPolygon(where, path) == 1; }) %
           2 ==
         1;
}

/// The rectangle over x from west to east that is higher than all of these paths.
clip::Path slab(const clip::Paths & paths, clip::cInt west, clip::cInt east)
{
  clip::cInt south = paths.front().front().Y;
  clip::cInt north = south;
  for (const clip::Path & path : paths) {
    for (const clip::IntPoint & point : path) {
      south = std::min(south, point.Y);
      north = std::max(north, point.Y);
    }
  }
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

clip::PolyTree partWithin(const clip::Paths & paths, const clip::Path & rectangle)
{
  clip::Clipper clipper(clip::ioStrictlySimple);
  clipper.AddPaths(paths, clip::ptSubject, true);
  clipper.AddPath(rectangle, clip::ptClip, true);
  clip::PolyTree part;
  clipper.Execute(clip::ctIntersection, part, clip::pftNonZero, clip::pftNonZero);
  return part;
}

void appendWithoutHoles(const clip::PolyNode & outer, clip::Paths & simple);

/// Parts of the polygons of a tree, cut through the middle of their holes until none has any.
void appendTree(const clip::PolyNode & parent, clip::Paths & simple)
{
  for (const clip::PolyNode * const outer : parent.Childs) {
    appendWithoutHoles(*outer, simple);
    for (const clip::PolyNode * const hole : outer->Childs) {
      appendTree(*hole, simple);
    }
  }
}

void appendWithoutHoles(const clip::PolyNode & outer, clip::Paths & simple)
{
  if (outer.Childs.empty()) {
    simple.push_back(outer.Contour);
    return;
  }
  clip::Paths paths{outer.Contour};
  for (const clip::PolyNode * const hole : outer.Childs) {
    paths.push_back(hole->Contour);
  }
  const auto byX = [](const clip::IntPoint & a, const clip::IntPoint & b) { return a.X < b.X; };
  const auto [hole_west, hole_east] = std::minmax_element(paths[1].begin(), paths[1].end(), byX);
  const auto [west, east] = std::minmax_element(paths[0].begin(), paths[0].end(), byX);
  const clip::cInt middle = (hole_west->X + hole_east->X) / 2;
  appendTree(partWithin(paths, slab(paths, west->X, middle)), simple);
  appendTree(partWithin(paths, slab(paths, middle, east->X)), simple);
}

clip::Paths withoutHoles(const clip::Paths & paths)
{
  clip::Clipper clipper(clip::ioStrictlySimple);
  clipper.AddPaths(paths, clip::ptSubject, true);
  clip::PolyTree tree;
  clipper.Execute(clip::ctUnion, tree, clip::pftNonZero);
  clip::Paths simple;
  appendTree(tree, simple);
  return simple;
}
}  // namespace

void PolygonUnion::add(const std::vector<Outline> & outlines)
{
  clip::Paths all = unite(toPaths(outlines), clip::pftPositive);
  const clip::Paths before = toPaths(outlines_);
  all.insert(all.end(), before.begin(), before.end());
  outlines_.clear();
  for (const clip::Path & path : unite(all, clip::pftNonZero)) {
    outlines_.push_back(toOutline(path));
  }
}

void PolygonUnion::addUncovered(const std::vector<std::array<Vec2, 2>> & segments, double width)
{
  const clip::Paths covered = toPaths(outlines_);
  std::vector<Outline> strips;
  for (const auto & [a, b] : segments) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Vec2 side{-(b.y - a.y) / length * width / 2.0, (b.x - a.x) / length * width / 2.0};
    const Vec2 middle{(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
    if (
      !covers(covered, {middle.x + side.x, middle.y + side.y}) &&
      !covers(covered, {middle.x - side.x, middle.y - side.y})) {
      strips.push_back(
        {{a.x - side.x, a.y - side.y},
         {b.x - side.x, b.y - side.y},
         {b.x + side.x, b.y + side.y},
         {a.x + side.x, a.y + side.y}});
    }
  }
  add(strips);
}

std::vector<ConvexPolygon> PolygonUnion::convexPieces() const
{
  std::vector<ConvexPolygon> pieces;
  for (clip::Path path : withoutHoles(toPaths(outlines_))) {
    clip::CleanPolygon(path, kCleaningDistance * kUnitsPerMetre);
    for (ConvexPolygon & piece : convexDecomposition(toOutline(path))) {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}
}  // namespace f1tenth_sim2d
