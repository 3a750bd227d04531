#include "core/contacts/contact_recorder.h"

#include <algorithm>
#include <utility>

#include "core/contacts/box_units.h"

namespace f1tenth_sim2d
{
namespace
{
CarBody & carOf(b2Fixture & fixture)
{
  return *reinterpret_cast<CarBody *>(fixture.GetBody()->GetUserData().pointer);
}

/// m/s, relative speed of two bodies at a point, as they move now: contacts are not solved yet.
double speedBetween(const b2Fixture & one, const b2Fixture & other, const b2Vec2 & point)
{
  const b2Vec2 difference =
    one.GetBody()->GetLinearVelocityFromWorldPoint(point) - other.GetBody()->GetLinearVelocityFromWorldPoint(point);
  return fromBox(difference.Length());
}
}  // namespace

// Box2D's normal points from fixture A to fixture B.
template <typename Record>
void ContactRecorder::forEachCar(b2Contact & contact, Record record)
{
  b2Fixture & a = *contact.GetFixtureA();
  b2Fixture & b = *contact.GetFixtureB();
  if (pieceOf(a).owner == Piece::Owner::kCar) {
    record(View{a, b, -1.0F});
  }
  if (pieceOf(b).owner == Piece::Owner::kCar) {
    record(View{b, a, 1.0F});
  }
}

// The coefficients of two surfaces are combined as in Gazebo with ODE: the smaller one counts.
void ContactRecorder::BeginContact(b2Contact * contact)
{
  const Piece & a = pieceOf(*contact->GetFixtureA());
  const Piece & b = pieceOf(*contact->GetFixtureB());
  contact->SetFriction(std::min(a.friction, b.friction));
  contact->SetRestitution(std::min(a.restitution, b.restitution));
}

void ContactRecorder::PreSolve(b2Contact * contact, const b2Manifold *)
{
  forEachCar(*contact, [&](const View & view) { recordGeometry(view, *contact); });
}

void ContactRecorder::PostSolve(b2Contact * contact, const b2ContactImpulse * impulse)
{
  forEachCar(*contact, [&](const View & view) { recordImpulse(view, *contact, *impulse); });
}

StepContact & ContactRecorder::entry(const View & view)
{
  const Piece & other = pieceOf(view.other);
  StepContact key;
  key.own_solid = pieceOf(view.own).solid;
  key.other_owner = other.owner;
  key.other_body = other.body;
  key.other_solid = other.solid;
  std::vector<StepContact> & contacts = carOf(view.own).contacts;
  const auto found = std::find_if(
    contacts.begin(), contacts.end(), [&](const StepContact & contact) { return contact.isOfSamePair(key); });
  return found != contacts.end() ? *found : contacts.emplace_back(std::move(key));
}

void ContactRecorder::recordGeometry(const View & view, b2Contact & contact) const
{
  StepContact & kept = entry(view);
  if (kept.substep != substep_) {
    kept.positions.clear();
    kept.normals.clear();
    kept.depths.clear();
    kept.substep = substep_;
  }
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  for (int i = 0; i < contact.GetManifold()->pointCount; ++i) {
    kept.speed = std::max(kept.speed, speedBetween(view.own, view.other, manifold.points[i]));
    kept.positions.push_back(fromBox(manifold.points[i]));
    kept.normals.push_back({view.sign * manifold.normal.x, view.sign * manifold.normal.y});
    kept.depths.push_back(std::max(0.0, -fromBox(manifold.separations[i])));
  }
}

void ContactRecorder::recordImpulse(const View & view, b2Contact & contact, const b2ContactImpulse & impulse)
{
  StepContact & kept = entry(view);
  const b2Vec2 & centre = view.own.GetBody()->GetWorldCenter();
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  const b2Vec2 tangent = b2Cross(manifold.normal, 1.0F);
  for (int i = 0; i < impulse.count; ++i) {
    const b2Vec2 push =
      view.sign * (impulse.normalImpulses[i] * manifold.normal + impulse.tangentImpulses[i] * tangent);
    const Vec2 lever = fromBox(manifold.points[i] - centre);
    const Vec2 share = fromBox(push);
    kept.impulse = kept.impulse + share;
    kept.angular_impulse += cross(lever, share);
  }
}
}  // namespace f1tenth_sim2d
