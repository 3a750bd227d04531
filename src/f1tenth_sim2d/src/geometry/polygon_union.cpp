#include "geometry/polygon_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "f1tenth_sim2d/errors.h"
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

/// m; the integers for larger values are out of Clipper's range.
constexpr double kFarthest = 1e11;

void requireWithinReach(const Vec2 & corner)
{
  if (!(std::max(std::abs(corner.x), std::abs(corner.y)) <= kFarthest)) {
    throw Error(
      "a corner of an area is at (" + toText(corner.x) + ", " + toText(corner.y) + ") m, allowed is at most " +
      toText(kFarthest) + " m from the origin");
  }
}

clip::Path toPath(const Outline & outline)
{
  clip::Path path;
  for (const Vec2 & corner : outline) {
    requireWithinReach(corner);
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

/// The union of areas that are counter-clockwise. Halves are united first: the time of a single union grows with the
/// square of how many edges lie above one another.
clip::Paths uniteHalves(const clip::Path * first, const clip::Path * last)
{
  constexpr std::ptrdiff_t kAtOnce = 32;
  if (last - first <= kAtOnce) {
    return unite(clip::Paths(first, last), clip::pftPositive);
  }
  const clip::Path * const middle = first + (last - first) / 2;
  clip::Paths both = uniteHalves(first, middle);
  const clip::Paths second = uniteHalves(middle, last);
  both.insert(both.end(), second.begin(), second.end());
  return unite(both, clip::pftPositive);
}

std::vector<Outline> toOutlines(const clip::Paths & paths)
{
  std::vector<Outline> outlines;
  for (const clip::Path & path : paths) {
    outlines.push_back(toOutline(path));
  }
  return outlines;
}

/// Two areas, none of whose own outlines cross, as one.
std::vector<Outline> joined(const std::vector<Outline> & area, clip::Paths other)
{
  const clip::Paths paths = toPaths(area);
  other.insert(other.end(), paths.begin(), paths.end());
  return toOutlines(unite(other, clip::pftNonZero));
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

struct Bounds
{
  clip::IntPoint low;
  clip::IntPoint high;

  explicit Bounds(const clip::Path & path) : low(path.front()), high(low)
  {
    for (const clip::IntPoint & point : path) {
      low = {std::min(low.X, point.X), std::min(low.Y, point.Y)};
      high = {std::max(high.X, point.X), std::max(high.Y, point.Y)};
    }
  }

  clip::cInt width() const { return high.X - low.X; }
  clip::cInt depth() const { return high.Y - low.Y; }
  clip::Path rectangle() const { return {low, {high.X, low.Y}, high, {low.X, high.Y}}; }
};

/// Both halves of the bounds, cut through the middle of the hole across its longer side.
std::array<Bounds, 2> halves(const Bounds & bounds, const Bounds & hole)
{
  std::array<Bounds, 2> parts{bounds, bounds};
  if (hole.width() >= hole.depth()) {
    parts[0].high.X = parts[1].low.X = (hole.low.X + hole.high.X) / 2;
  } else {
    parts[0].high.Y = parts[1].low.Y = (hole.low.Y + hole.high.Y) / 2;
  }
  return parts;
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

/// Holes that are not wide are closed: nothing lies between their sides along which they could be cut.
bool isWide(const Bounds & hole)
{
  return static_cast<double>(std::max(hole.width(), hole.depth())) > kCleaningDistance * kUnitsPerMetre;
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
  clip::Paths paths{outer.Contour};
  for (const clip::PolyNode * const hole : outer.Childs) {
    if (isWide(Bounds(hole->Contour))) {
      paths.push_back(hole->Contour);
    }
  }
  if (paths.size() == 1) {
    simple.push_back(outer.Contour);
    return;
  }
  for (const Bounds & half : halves(Bounds(paths[0]), Bounds(paths[1]))) {
    appendTree(partWithin(paths, half.rectangle()), simple);
  }
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
  outlines_ = joined(outlines_, unite(toPaths(outlines), clip::pftPositive));
}

void PolygonUnion::addEach(const std::vector<Outline> & areas)
{
  const clip::Paths paths = toPaths(areas);
  outlines_ = joined(outlines_, uniteHalves(paths.data(), paths.data() + paths.size()));
}

void PolygonUnion::addUncovered(const std::vector<std::array<Vec2, 2>> & segments, double width)
{
  const clip::Paths covered = toPaths(outlines_);
  std::vector<Outline> strips;
  for (const auto & [a, b] : segments) {
    const double length = distance(a, b);
    const Vec2 side{-(b.y - a.y) / length * width / 2.0, (b.x - a.x) / length * width / 2.0};
    const Vec2 middle = 0.5 * (a + b);
    if (!covers(covered, middle + side) && !covers(covered, middle - side)) {
      strips.push_back({a - side, b - side, b + side, a + side});
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

std::vector<Outline> coveredOddly(const std::vector<Outline> & outlines)
{
  return toOutlines(unite(toPaths(outlines), clip::pftEvenOdd));
}
}  // namespace f1tenth_sim2d
