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
constexpr double kFirstReach = 0.25;  // m

b2Transform transformOf(const Pose2 & pose)
{
  return {toBox(Vec2{pose.x, pose.y}), b2Rot(static_cast<float>(pose.yaw))};
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

/// Calls visit(distance, other piece) for all pairs of own pieces and pieces of the other car that could touch.
template <typename Visit>
void forEachPair(const PlacedCar & own, const Piece & other, const b2Transform & at_other, Visit visit)
{
  const b2Transform at_own = transformOf(own.pose);
  for (const Piece & piece : own.body.pieces) {
    if (canTouch(piece, other)) {
      visit(distance(piece, at_own, other, at_other), other);
    }
  }
}

template <typename Visit>
void forEachCarPair(const std::vector<PlacedCar> & cars, std::size_t own, double limit, Visit visit)
{
  for (std::size_t i = 0; i < cars.size(); ++i) {
    const double centres = length({cars[i].pose.x - cars[own].pose.x, cars[i].pose.y - cars[own].pose.y});
    if (i == own || centres - radius(cars[i]) - radius(cars[own]) > limit) {
      continue;
    }
    const b2Transform at_other = transformOf(cars[i].pose);
    for (const Piece & other : cars[i].body.pieces) {
      forEachPair(cars[own], other, at_other, visit);
    }
  }
}

template <typename Visit>
void forEachModelPair(const PlacedCar & own, const CollisionWorld & world, double reach, Visit visit)
{
  world.forEachModelPieceNear(
    own.body, {own.pose.x, own.pose.y}, reach,
    [&](const Piece & other, const b2Transform & at_other) { forEachPair(own, other, at_other, visit); });
}
}  // namespace

double clearance(const std::vector<PlacedCar> & cars, std::size_t own, const CollisionWorld & world, double limit)
{
  double least = limit;
  const auto keepLeast = [&](double candidate, const Piece &) { least = std::min(least, candidate); };
  forEachCarPair(cars, own, limit, keepLeast);
  for (double reach = std::min(kFirstReach, limit);; reach = std::min(2.0 * reach, limit)) {
    forEachModelPair(cars[own], world, reach, keepLeast);
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
  forEachCarPair(cars, own, 0.0, keepFirst);
  forEachModelPair(cars[own], world, 0.0, keepFirst);
  return first;
}
}  // namespace f1tenth_sim2d
