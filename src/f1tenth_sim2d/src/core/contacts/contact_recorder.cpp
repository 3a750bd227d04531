#include "core/contacts/contact_recorder.h"

#include <algorithm>

#include "core/contacts/box_units.h"

namespace f1tenth_sim2d
{
namespace
{
bool isCar(const Piece & piece)
{
  return piece.owner == Piece::Owner::kCar;
}
}  // namespace

void ContactRecorder::beginStep()
{
  for (std::vector<StepContact> & contacts : contacts_) {
    contacts.clear();
  }
  substep_ = 0;
}

// The coefficients of two surfaces are combined as Gazebo does it with ODE: by the smaller one.
void ContactRecorder::BeginContact(b2Contact * contact)
{
  const Piece & a = pieceOf(*contact->GetFixtureA());
  const Piece & b = pieceOf(*contact->GetFixtureB());
  contact->SetFriction(std::min(a.friction, b.friction));
  contact->SetRestitution(std::min(a.restitution, b.restitution));
}

void ContactRecorder::PreSolve(b2Contact * contact, const b2Manifold *)
{
  const Piece & a = pieceOf(*contact->GetFixtureA());
  const Piece & b = pieceOf(*contact->GetFixtureB());
  if (isCar(a)) {
    recordGeometry(a, b, contact, -1.0F);
  }
  if (isCar(b)) {
    recordGeometry(b, a, contact, 1.0F);
  }
}

void ContactRecorder::PostSolve(b2Contact * contact, const b2ContactImpulse * impulse)
{
  const Piece & a = pieceOf(*contact->GetFixtureA());
  const Piece & b = pieceOf(*contact->GetFixtureB());
  if (isCar(a)) {
    recordImpulse(a, b, contact->GetFixtureA()->GetBody()->GetWorldCenter(), contact, impulse, -1.0F);
  }
  if (isCar(b)) {
    recordImpulse(b, a, contact->GetFixtureB()->GetBody()->GetWorldCenter(), contact, impulse, 1.0F);
  }
}

StepContact & ContactRecorder::entry(const Piece & own, const Piece & other)
{
  StepContact key;
  key.own_solid = own.solid;
  key.other_owner = other.owner;
  key.other_body = other.body;
  key.other_solid = other.solid;
  std::vector<StepContact> & contacts = contacts_[own.body];
  const auto found = std::find_if(
    contacts.begin(), contacts.end(), [&](const StepContact & contact) { return contact.isOfSamePair(key); });
  return found != contacts.end() ? *found : contacts.emplace_back(std::move(key));
}

// Box2D's normal points from fixture A to fixture B.
void ContactRecorder::recordGeometry(const Piece & own, const Piece & other, b2Contact * contact, float sign)
{
  StepContact & kept = entry(own, other);
  if (kept.substep != substep_) {
    kept.positions.clear();
    kept.normals.clear();
    kept.depths.clear();
    kept.substep = substep_;
  }
  b2WorldManifold manifold;
  contact->GetWorldManifold(&manifold);
  for (int i = 0; i < contact->GetManifold()->pointCount; ++i) {
    kept.positions.push_back(fromBox(manifold.points[i]));
    kept.normals.push_back({sign * manifold.normal.x, sign * manifold.normal.y});
    kept.depths.push_back(std::max(0.0, -fromBox(manifold.separations[i])));
  }
}

void ContactRecorder::recordImpulse(
  const Piece & own, const Piece & other, const b2Vec2 & centre, b2Contact * contact, const b2ContactImpulse * impulse,
  float sign)
{
  StepContact & kept = entry(own, other);
  b2WorldManifold manifold;
  contact->GetWorldManifold(&manifold);
  const b2Vec2 tangent = b2Cross(manifold.normal, 1.0F);
  for (int i = 0; i < impulse->count; ++i) {
    const b2Vec2 push = sign * (impulse->normalImpulses[i] * manifold.normal + impulse->tangentImpulses[i] * tangent);
    const Vec2 lever = fromBox(manifold.points[i] - centre);
    const Vec2 share = fromBox(push);
    kept.impulse = {kept.impulse.x + share.x, kept.impulse.y + share.y};
    kept.angular_impulse += lever.x * share.y - lever.y * share.x;
  }
}
}  // namespace f1tenth_sim2d
