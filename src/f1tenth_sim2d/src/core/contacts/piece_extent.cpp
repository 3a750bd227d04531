#include "core/contacts/piece_extent.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

#include "core/contacts/box_units.h"

namespace f1tenth_sim2d
{
namespace
{
double reach(const b2PolygonShape & polygon)
{
  float squared = 0.0F;
  for (int i = 0; i < polygon.m_count; ++i) {
    squared = std::max(squared, polygon.m_vertices[i].LengthSquared());
  }
  return fromBox(std::sqrt(squared));
}

double reach(const b2CircleShape & circle)
{
  return fromBox(circle.m_p.Length() + circle.m_radius);
}

struct Moment
{
  double area{0.0};
  double first{0.0};  // integral of the distance from the origin
};

/// By the midpoints of the edges, which is exact for a quadratic and close enough for a distance.
Moment moment(const Vec2 & a, const Vec2 & b, const Vec2 & c)
{
  const double size = 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
  const auto distance = [](const Vec2 & p, const Vec2 & q) { return 0.5 * maths::hypot(p.x + q.x, p.y + q.y); };
  return {size, size / 3.0 * (distance(a, b) + distance(b, c) + distance(c, a))};
}

Moment moment(const b2PolygonShape & polygon)
{
  Moment sum;
  for (int i = 1; i + 1 < polygon.m_count; ++i) {
    const Moment part =
      moment(fromBox(polygon.m_vertices[0]), fromBox(polygon.m_vertices[i]), fromBox(polygon.m_vertices[i + 1]));
    sum = {sum.area + part.area, sum.first + part.first};
  }
  return sum;
}

Moment moment(const b2CircleShape & circle)
{
  const double radius = fromBox(circle.m_radius);
  const double size = b2_pi * radius * radius;
  return {size, size * std::max(2.0 / 3.0 * radius, fromBox(circle.m_p.Length()))};
}
}  // namespace

double outerRadius(const std::vector<Piece> & pieces)
{
  double radius = 0.0;
  for (const Piece & piece : pieces) {
    radius = std::max(radius, std::visit([](const auto & shape) { return reach(shape); }, piece.shape));
  }
  return radius;
}

double meanRadius(const std::vector<Piece> & pieces)
{
  Moment sum;
  for (const Piece & piece : pieces) {
    const Moment part = std::visit([](const auto & shape) { return moment(shape); }, piece.shape);
    sum = {sum.area + part.area, sum.first + part.first};
  }
  return sum.area > 0.0 ? sum.first / sum.area : 0.0;
}
}  // namespace f1tenth_sim2d
