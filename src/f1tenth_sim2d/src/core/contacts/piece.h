#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <variant>
#include <vector>

#include "f1tenth_sim2d/section.h"
#include "f1tenth_sim2d/world_model.h"
#include "geometry/heights.h"

/// Convex pieces of the shadows that solids cast on the ground: what touches what.
namespace f1tenth_sim2d
{
using PieceShape = std::variant<b2PolygonShape, b2CircleShape>;

/// Which part of a solid's height a piece is the shadow of.
///
/// What a car touches of a sphere or of a tilted box depends on the vertical span of the car's own solid. Car
/// solids of equal span form a layer, and such solids of the world have pieces of their own in every layer.
enum class Layer : int
{
  kModelsOnly = -2,  ///< all of a solid that has pieces in the layers: touches other models, but no car
  kWholeSolid = -1   ///< upright: looks the same in every layer
};

/// A circle around a piece, in the frame of the body, Box2D units.
struct PieceBounds
{
  b2Vec2 centre;
  float radius;
};

struct Piece
{
  enum class Owner
  {
    kModel,
    kCar
  };

  PieceShape shape;    ///< in the frame of the body, Box2D units
  PieceBounds bounds;  ///< of the shape
  Owner owner;
  std::uint32_t body;   ///< index of the model, or id of the car
  std::uint32_t solid;  ///< index within its owner
  Heights span;         ///< m, of the whole solid
  Layer layer{Layer::kWholeSolid};
  float friction{1.0F};
  float restitution{0.0F};

  const b2Shape & boxShape() const;
};

/// Whether bodies of these spans can touch. An overlap below a millimetre does not count: wheels stand on floors.
bool overlap(const Heights & a, const Heights & b);

/// Whether two pieces of different bodies touch where their shadows do.
bool canTouch(const Piece & a, const Piece & b);

/// Appends the footprint of a solid as pieces, its points moved by -origin; slivers without area are left out.
/// @param properties  of the pieces, but for shape, friction and restitution
void appendPieces(
  std::vector<Piece> & pieces, const Section & footprint, const Vec2 & origin, const Solid & solid,
  const Piece & properties);
}  // namespace f1tenth_sim2d
