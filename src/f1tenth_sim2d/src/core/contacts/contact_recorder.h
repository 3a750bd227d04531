#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "core/contacts/piece.h"
#include "f1tenth_sim2d/car_id.h"
#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// What touches one solid of a car in one physics step.
struct StepContact
{
  std::uint32_t own_solid;
  Piece::Owner other_owner;
  std::uint32_t other_body;
  std::uint32_t other_solid;
  std::vector<Vec2> positions;  ///< m, world
  std::vector<Vec2> normals;    ///< from the other body towards the car
  std::vector<double> depths;   ///< m
  Vec2 impulse;                 ///< N s, on the car
  double angular_impulse{0.0};  ///< N m s, about the car's centre of mass
  int substep{0};               ///< of the positions, normals and depths: the last one in which the pair touched

  bool isOfSamePair(const StepContact & other) const
  {
    return own_solid == other.own_solid && other_owner == other.other_owner && other_body == other.other_body &&
           other_solid == other.other_solid;
  }
};

/// Listens to Box2D and keeps what touches the cars during one physics step, which may take several substeps.
class ContactRecorder : public b2ContactListener
{
public:
  void setCarCount(std::size_t count) { contacts_.resize(count); }
  void beginStep();
  void beginSubstep() { ++substep_; }
  const std::vector<StepContact> & contacts(std::size_t car) const { return contacts_[car]; }

  void BeginContact(b2Contact * contact) override;
  void PreSolve(b2Contact * contact, const b2Manifold * old_manifold) override;
  void PostSolve(b2Contact * contact, const b2ContactImpulse * impulse) override;

private:
  StepContact & entry(const Piece & own, const Piece & other);
  void recordGeometry(const Piece & own, const Piece & other, b2Contact * contact, float sign);
  void recordImpulse(
    const Piece & own, const Piece & other, const b2Vec2 & centre, b2Contact * contact,
    const b2ContactImpulse * impulse, float sign);

  std::vector<std::vector<StepContact>> contacts_;  ///< by car
  int substep_{0};
};

/// The piece that a fixture was made of.
inline const Piece & pieceOf(const b2Fixture & fixture)
{
  return *reinterpret_cast<const Piece *>(const_cast<b2Fixture &>(fixture).GetUserData().pointer);
}
}  // namespace f1tenth_sim2d
