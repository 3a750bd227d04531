#include "core/contacts/ground_friction.h"

#include <algorithm>
#include <limits>

#include "core/contacts/box_units.h"
#include "core/contacts/piece_extent.h"

namespace f1tenth_sim2d
{
namespace
{
/// Friction coefficient of the lowest solid: the one that the model stands on.
double footFriction(const std::vector<Piece> & pieces)
{
  const auto lowest = std::min_element(
    pieces.begin(), pieces.end(), [](const Piece & a, const Piece & b) { return a.span.lowest < b.span.lowest; });
  return lowest != pieces.end() ? lowest->friction : 1.0;
}
}  // namespace

double groundFriction(const WorldDescription & world)
{
  double mu = std::numeric_limits<double>::infinity();
  for (const ModelDescription & model : world.models) {
    for (const Solid & solid : model.solids) {
      if (std::holds_alternative<Plane>(solid.shape)) {
        mu = std::min(mu, solid.mu);
      }
    }
  }
  return mu;
}

void addFrictionJoint(
  b2Body & ground_body, b2Body & body, const std::vector<Piece> & pieces, double ground, double weight)
{
  const double force = std::min(ground, footFriction(pieces)) * weight;
  b2FrictionJointDef definition;
  definition.Initialize(&ground_body, &body, body.GetPosition());
  definition.collideConnected = true;
  definition.maxForce = toBox(force);
  definition.maxTorque = toBoxSquared(force * meanRadius(pieces));
  body.GetWorld()->CreateJoint(&definition);
  body.SetAwake(false);
}
}  // namespace f1tenth_sim2d
