#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "core/contacts/box_units.h"
#include "core/contacts/car_body.h"
#include "core/contacts/contact_recorder.h"
#include "core/contacts/piece_set.h"
#include "core/contacts/world_pieces.h"
#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Pose and velocity of a movable model in Box2D; static ones have none.
struct ModelMotion
{
  b2Vec2 centre{0.0F, 0.0F};
  float angle{0.0F};
  b2Vec2 velocity{0.0F, 0.0F};
  float yaw_rate{0.0F};
  bool awake{false};
  bool moved{false};  ///< false: it stands where it started, to the last bit
  bool known{false};  ///< false: as the world says
};

/// The world as rigid bodies in the plane. Cars take part only while they are near something they could touch: the
/// vehicle model moves them, and Box2D adds what contacts change. Box2D knows only the static pieces that
/// something has been near, so that a world of many walls is quickly rebuilt.
class CollisionWorld
{
public:
  /// @param world, pieces  outlive this
  CollisionWorld(const WorldDescription & world, const WorldPieces & pieces);

  /// Makes room for a car, so that adding it cannot fail.
  void prepareFor(const CarBody & car);
  /// Adds a car that takes no part yet.
  /// @param car  for which room was made; stays at its address as long as this lives
  void add(CarBody & car) noexcept;

  /// Lets a car take part in the next step, from this pose and with this velocity.
  void place(CarBody & car, const PlanarMotion & motion);
  /// Takes a car out.
  static void remove(CarBody & car);

  /// Advances by dt seconds; the cars then know their contacts.
  /// @param travel  m, the farthest that anything taking part moves
  void step(double dt, double travel);
  /// Effect of the last step on a car that took part in it.
  static ContactEffect effect(const CarBody & car);

  /// Whether nothing has ever taken part in a step or been put somewhere: it is as built.
  bool isPristine() const { return is_pristine_; }
  /// Whether any movable model moves.
  bool isAwake() const { return is_awake_; }
  /// The farthest that a point of a movable model moves within dt seconds, m.
  double movableTravel(double dt) const;
  /// Pose of a model in the world.
  Pose2 modelPose(std::size_t model) const;
  ModelState modelState(std::size_t model) const;
  /// Puts a movable model somewhere, moving.
  void placeModel(std::size_t model, const ModelState & state);
  /// Motions of all models, to be given to another world of the same models.
  std::vector<ModelMotion> motions() const;
  /// @param motions  by model; missing ones are left as they are
  void setMotions(const std::vector<ModelMotion> & motions);

  /// Calls visit(piece, transform of its body) for the pieces of models that a car could touch, if its centre of mass
  /// were at a point, and that may be within `reach` metres of it.
  template <typename Visit>
  void forEachModelPieceNear(const CarBody & car, const Vec2 & point, double reach, Visit visit) const
  {
    const double radius = car.participant.outer_radius + reach;
    visitSet(pieces_.whole(), toBox(point), radius, visit);
    for (const PieceSet * layer : car.layers) {
      visitSet(*layer, toBox(point), radius, visit);
    }
  }

private:
  struct Movable
  {
    Participant participant;
    std::size_t model;
  };
  /// Pieces that Box2D has, and which of the static ones.
  struct Known
  {
    const PieceSet * pieces;
    std::vector<bool> has_fixed;
    bool in_use;  ///< by a car that is there, or by every car
  };

  static b2AABB squareAround(const b2Vec2 & centre, double half_width);
  template <typename Visit>
  void visitSet(const PieceSet & set, const b2Vec2 & centre, double radius, Visit & visit) const
  {
    const b2Transform in_world(b2Vec2_zero, b2Rot(0.0F));
    set.forEachFixedIn(squareAround(centre, radius), [&](std::size_t, const Piece & piece) { visit(piece, in_world); });
    for (const Movable & movable : movables_) {
      const b2Transform & at = movable.participant.body->GetTransform();
      if (fromBox(b2Distance(at.p, centre)) <= radius + movable.participant.outer_radius) {
        const auto [first, end] = set.ofMovable(movable.model);
        for (const Piece * piece = first; piece != end; ++piece) {
          visit(*piece, at);
        }
      }
    }
  }

  void setMotion(std::size_t model, const ModelMotion & motion);
  void addBodies();
  b2Body * addMovable(const ModelDescription & model, const ModelBody & start);
  void addGroundFriction();
  void know(const PieceSet & pieces);
  void addMovablePieces(Known & known);
  void surroundParticipants(double travel);
  void surround(Participant & participant, double travel);
  std::vector<Piece> wholePieces(std::size_t model) const;

  class PieceFilter : public b2ContactFilter
  {
    bool ShouldCollide(b2Fixture * a, b2Fixture * b) override;
  };

  const WorldDescription & description_;
  const WorldPieces & pieces_;
  PieceFilter filter_;
  ContactRecorder recorder_;
  b2World world_{b2Vec2_zero};
  b2Body * static_body_;
  std::vector<b2Body *> model_bodies_;  ///< by model; the static body for all static ones
  std::vector<bool> have_moved_;        ///< by model: whether it was ever anywhere else than where it started
  std::vector<Movable> movables_;
  std::vector<CarBody *> cars_;
  std::vector<Known> known_;  ///< whole solids, then layers in the order in which cars brought them
  bool is_pristine_{true};
  bool is_awake_{false};  ///< models wake and fall asleep in steps, or when they are put somewhere
};
}  // namespace f1tenth_sim2d
