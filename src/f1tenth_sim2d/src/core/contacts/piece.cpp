#include "core/contacts/piece.h"

#include <algorithm>
#include <cmath>

#include "core/contacts/box_units.h"
#include "geometry/planar.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kLeastEdge = 1e-5;      // m
constexpr double kLeastArea = 1e-8;      // m^2
constexpr double kLeastOverlap = 0.001;  // m

ConvexPolygon withoutShortEdges(const ConvexPolygon & polygon)
{
  ConvexPolygon kept;
  for (const Vec2 & p : polygon) {
    if (kept.empty() || distance(kept.back(), p) > kLeastEdge) {
      kept.push_back(p);
    }
  }
  while (kept.size() > 1 && distance(kept.back(), kept[0]) <= kLeastEdge) {
    kept.pop_back();
  }
  return kept;
}

Vec2 middle(const ConvexPolygon & polygon)
{
  Vec2 sum;
  for (const Vec2 & p : polygon) {
    sum = sum + p;
  }
  const auto count = static_cast<double>(polygon.size());
  return {sum.x / count, sum.y / count};
}

// b2PolygonShape::Set() would merge corners, and replaces what it rejects by a box of one unit.
b2PolygonShape polygonShape(const ConvexPolygon & polygon, const Vec2 & origin)
{
  b2PolygonShape shape;
  shape.m_radius = 0.0F;
  shape.m_count = static_cast<int32>(polygon.size());
  shape.m_centroid = toBox(middle(polygon) - origin);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 & a = polygon[i];
    const Vec2 & b = polygon[(i + 1) % polygon.size()];
    const double length = distance(a, b);
    shape.m_vertices[i] = toBox(a - origin);
    shape.m_normals[i] = {static_cast<float>((b.y - a.y) / length), static_cast<float>((a.x - b.x) / length)};
  }
  return shape;
}

/// Parts of a convex polygon that have no more corners than Box2D takes.
std::vector<ConvexPolygon> split(const ConvexPolygon & polygon)
{
  std::vector<ConvexPolygon> parts;
  for (std::size_t first = 1; first + 1 < polygon.size(); first += b2_maxPolygonVertices - 2) {
    ConvexPolygon part{polygon[0]};
    const std::size_t last = std::min(first + b2_maxPolygonVertices - 2, polygon.size() - 1);
    part.insert(part.end(), polygon.begin() + first, polygon.begin() + last + 1);
    parts.push_back(part);
  }
  return parts;
}
/// Shapes of a footprint, its points moved by -origin; slivers without area are left out.
std::vector<PieceShape> pieceShapes(const Section & footprint, const Vec2 & origin)
{
  std::vector<PieceShape> shapes;
  for (const Outline & outline : footprint.outlines) {
    for (const ConvexPolygon & part : split(withoutShortEdges(outline))) {
      if (signedArea(part) > kLeastArea) {
        shapes.emplace_back(polygonShape(part, origin));
      }
    }
  }
  for (const Circle & circle : footprint.circles) {
    b2CircleShape shape;
    shape.m_p = toBox(circle.centre - origin);
    shape.m_radius = toBox(circle.radius);
    shapes.emplace_back(shape);
  }
  return shapes;
}

PieceBounds boundsOf(const b2PolygonShape & polygon)
{
  float squared = 0.0F;
  for (int i = 0; i < polygon.m_count; ++i) {
    squared = std::max(squared, b2DistanceSquared(polygon.m_centroid, polygon.m_vertices[i]));
  }
  return {polygon.m_centroid, std::sqrt(squared)};
}

PieceBounds boundsOf(const b2CircleShape & circle)
{
  return {circle.m_p, circle.m_radius};
}
}  // namespace

const b2Shape & Piece::boxShape() const
{
  return std::visit([](const auto & concrete) -> const b2Shape & { return concrete; }, shape);
}

bool overlap(const Heights & a, const Heights & b)
{
  return std::min(a.highest, b.highest) - std::max(a.lowest, b.lowest) > kLeastOverlap;
}

bool canTouch(const Piece & a, const Piece & b)
{
  if (a.owner == b.owner) {
    const bool layered = a.owner == Piece::Owner::kModel && (a.layer >= Layer{0} || b.layer >= Layer{0});
    return !layered && overlap(a.span, b.span);
  }
  const Piece & model = a.owner == Piece::Owner::kModel ? a : b;
  const Piece & car = a.owner == Piece::Owner::kModel ? b : a;
  return model.layer == Layer::kWholeSolid ? overlap(a.span, b.span) : model.layer == car.layer;
}

void appendPieces(
  std::vector<Piece> & pieces, const Section & footprint, const Vec2 & origin, const Solid & solid,
  const Piece & properties)
{
  for (PieceShape & shape : pieceShapes(footprint, origin)) {
    Piece & piece = pieces.emplace_back(properties);
    piece.shape = shape;
    piece.bounds = std::visit([](const auto & concrete) { return boundsOf(concrete); }, shape);
    piece.friction = static_cast<float>(solid.mu);
    piece.restitution = static_cast<float>(solid.restitution);
  }
}
}  // namespace f1tenth_sim2d
