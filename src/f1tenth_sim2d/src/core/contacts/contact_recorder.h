#pragma once

#include <box2d/box2d.h>

#include "core/contacts/car_body.h"
#include "core/contacts/contact_log.h"
#include "core/contacts/piece.h"

namespace f1tenth_sim2d
{
/// Listens to Box2D and tells the cars what touches them during one physics step, which may take several substeps.
class ContactRecorder : public b2ContactListener
{
public:
  void beginStep() { substep_ = 0; }
  void beginSubstep() { ++substep_; }

  void BeginContact(b2Contact * contact) override;
  void PreSolve(b2Contact * contact, const b2Manifold * old_manifold) override;
  void PostSolve(b2Contact * contact, const b2ContactImpulse * impulse) override;

private:
  /// A contact as a car sees it.
  struct View
  {
    b2Fixture & own;
    b2Fixture & other;
    float sign;  ///< of Box2D's normal, to make it point towards the car
  };

  template <typename Record>
  static void forEachCar(b2Contact & contact, Record record);
  static StepContact & entry(const View & view);
  void recordGeometry(const View & view, b2Contact & contact) const;
  static void recordImpulse(const View & view, b2Contact & contact, const b2ContactImpulse & impulse);

  int substep_{0};
};

/// The piece that a fixture was made from.
inline const Piece & pieceOf(const b2Fixture & fixture)
{
  return *reinterpret_cast<const Piece *>(const_cast<b2Fixture &>(fixture).GetUserData().pointer);
}
}  // namespace f1tenth_sim2d
