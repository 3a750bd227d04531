#include "core/contacts/clearance.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kFirstReach = 0.25;     // m
constexpr double kFloatRounding = 1e-3;  // m, more than the error of distances in single precision

b2Transform transformOf(const Pose2 & pose)
{
  return {toBox(pose.position()), b2Rot(static_cast<float>(pose.yaw))};
}

double distance(const Piece & a, const b2Transform & at_a, const Piece & b, const b2Transform & at_b)
{
  b2DistanceInput input;
  input.proxyA.Set(&a.boxShape(), 0);
  input.proxyB.Set(&b.boxShape(), 0);
  input.transformA = at_a;
  input.transformB = at_b;
  input.useRadii = true;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput output;
  b2Distance(&output, &cache, &input);
  return fromBox(output.distance);
}

double radius(const PlacedCar & car)
{
  return car.body.participant.outer_radius;
}

// Lower bounds of the distance from a point, Box2D units, which take a fraction of the time of b2Distance.
float distanceAtLeast(const b2Vec2 & point, const b2PolygonShape & polygon)
{
  float farthest = 0.0F;
  for (int i = 0; i < polygon.m_count; ++i) {
    farthest = std::max(farthest, b2Dot(polygon.m_normals[i], point - polygon.m_vertices[i]));
  }
  return farthest;
}

float distanceAtLeast(const b2Vec2 & point, const b2CircleShape & circle)
{
  return b2Distance(point, circle.m_p) - circle.m_radius;
}

/// Lower bound of the distance from a circle to a piece, m.
double gap(const PieceBounds & circle, const b2Transform & at, const Piece & other)
{
  const b2Vec2 centre = b2Mul(at, circle.centre);
  return fromBox(
    std::visit([&](const auto & shape) { return distanceAtLeast(centre, shape); }, other.shape) - circle.radius);
}

/// Calls visit(distance, other piece) for the pairs of own pieces and pieces of another that could touch.
class OwnPieces
{
public:
  /// @param limit  m, beyond which distances need not be visited; reread before each pair
  OwnPieces(const PlacedCar & own, const double & limit)
  : pieces_(own.body.pieces), at_(transformOf(own.pose)), limit_(limit)
  {
  }

  template <typename Visit>
  void visitPairs(const Piece & other, const b2Transform & at_other, Visit & visit) const
  {
    const b2Transform own_in_other = b2MulT(at_other, at_);
    for (const Piece & piece : pieces_) {
      if (canTouch(piece, other) && gap(piece.bounds, own_in_other, other) <= limit_ + kFloatRounding) {
        visit(distance(piece, at_, other, at_other), other);
      }
    }
  }

private:
  const std::vector<Piece> & pieces_;
  const b2Transform at_;
  const double & limit_;
};

template <typename Visit>
void forEachCarPair(const std::vector<PlacedCar> & cars, std::size_t own, const double & limit, Visit visit)
{
  const OwnPieces pieces(cars[own], limit);
  for (std::size_t i = 0; i < cars.size(); ++i) {
    const double centres = length(cars[i].pose.position() - cars[own].pose.position());
    if (i == own || centres - radius(cars[i]) - radius(cars[own]) > limit + kFloatRounding) {
      continue;
    }
    const b2Transform at_other = transformOf(cars[i].pose);
    for (const Piece & other : cars[i].body.pieces) {
      pieces.visitPairs(other, at_other, visit);
    }
  }
}

template <typename Visit>
void forEachModelPair(
  const PlacedCar & own, const CollisionWorld & world, double reach, const double & limit, Visit visit)
{
  const OwnPieces pieces(own, limit);
  world.forEachModelPieceNear(
    own.body, own.pose.position(), reach,
    [&](const Piece & other, const b2Transform & at_other) { pieces.visitPairs(other, at_other, visit); });
}
}  // namespace

double clearance(const std::vector<PlacedCar> & cars, std::size_t own, const CollisionWorld & world, double limit)
{
  double least = limit;
  const auto keepLeast = [&](double candidate, const Piece &) { least = std::min(least, candidate); };
  forEachCarPair(cars, own, least, keepLeast);
  for (double reach = std::min(kFirstReach, limit);; reach = std::min(2.0 * reach, limit)) {
    forEachModelPair(cars[own], world, reach, least, keepLeast);
    if (least <= reach || reach >= limit) {
      return least;
    }
  }
}

const Piece * firstOverlap(const std::vector<PlacedCar> & cars, std::size_t own, const CollisionWorld & world)
{
  const Piece * first = nullptr;
  const auto order = [](const Piece & piece) { return std::make_tuple(piece.owner, piece.body, piece.solid); };
  const auto keepFirst = [&](double candidate, const Piece & other) {
    if (candidate == 0.0 && (first == nullptr || order(other) < order(*first))) {
      first = &other;
    }
  };
  const double touching = 0.0;
  forEachCarPair(cars, own, touching, keepFirst);
  forEachModelPair(cars[own], world, touching, touching, keepFirst);
  return first;
}
}  // namespace f1tenth_sim2d
