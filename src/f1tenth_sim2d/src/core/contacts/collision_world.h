#pragma once

#include <box2d/box2d.h>

#include <memory>
#include <optional>
#include <vector>

#include "core/contacts/box_units.h"
#include "core/contacts/contact_recorder.h"
#include "core/contacts/piece.h"
#include "core/contacts/world_pieces.h"
#include "f1tenth_sim2d/car_id.h"
#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/model_state.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// What Box2D needs to know of a car.
struct CarBody
{
  const std::vector<Piece> & pieces;  ///< outlive the world
  double mass;                        ///< kg
  double inertia;                     ///< kg m^2, about the centre of mass
};

/// Pose of a car's centre of mass and its velocity in the world, m/s and rad/s.
struct CarMotion
{
  Pose2 pose;
  Vec2 velocity;
  double yaw_rate{0.0};
};

/// How a movable model lies and moves, as Box2D has it; static ones have none.
struct ModelMotion
{
  b2Vec2 centre{0.0F, 0.0F};
  float angle{0.0F};
  b2Vec2 velocity{0.0F, 0.0F};
  float yaw_rate{0.0F};
  bool awake{false};
  bool known{false};  ///< false: as the world says
};

/// What became of a car that touched something in a step.
struct ContactEffect
{
  Pose2 displacement;           ///< m, rad: how far the car went in the step, contacts included
  Vec2 velocity_change;         ///< m/s, by contacts alone
  double yaw_rate_change{0.0};  ///< rad/s, by contacts alone
};

/// The world as rigid bodies in the plane. Cars take part only while they are near something they could touch: the
/// single-track model moves them, and Box2D adds what contacts change. Box2D knows only those static pieces that
/// something has been near, so that a world of many walls is soon made anew.
class CollisionWorld
{
public:
  /// @param world, pieces  outlive this
  CollisionWorld(const WorldDescription & world, const WorldPieces & pieces);

  /// Takes the first `count` layers of car solids in.
  void addLayers(std::size_t count);
  /// Adds a car that takes no part yet. Its layers must be there.
  void addCar(const CarBody & car);

  /// Lets a car take part in the next step, from this pose and with this velocity.
  void place(std::size_t car, const CarMotion & motion);
  /// Takes a car out.
  void remove(std::size_t car);

  /// Advances by dt seconds.
  /// @param travel  m, the farthest that anything which takes part goes
  void step(double dt, double travel);
  /// Contacts of the last step.
  const std::vector<StepContact> & contacts(std::size_t car) const { return recorder_.contacts(car); }
  /// Effect of the last step on a car that took part in it.
  ContactEffect effect(std::size_t car) const;

  /// Whether nothing has ever taken part in a step or been put somewhere: it is as on its first day.
  bool isPristine() const { return is_pristine_; }
  /// Whether any movable model moves.
  bool isAwake() const { return is_awake_; }
  /// The farthest that a point of a movable model goes within dt seconds, m.
  double movableTravel(double dt) const;
  /// Pose of a model in the world.
  Pose2 modelPose(std::size_t model) const;
  ModelState modelState(std::size_t model) const;
  /// Puts a movable model somewhere, moving.
  void placeModel(std::size_t model, const ModelState & state);
  /// Of all models, to be given to another world of the same models.
  std::vector<ModelMotion> motions() const;
  /// @param motions  by model; missing ones are left as they are
  void setMotions(const std::vector<ModelMotion> & motions);

  /// Calls visit(piece, transform of its body) for the pieces of models whose bounds touch the square around a point,
  /// `reach` metres to each side.
  template <typename Visit>
  void forEachModelPieceNear(const Vec2 & point, double reach, Visit visit) const
  {
    const b2AABB region = squareAround(toBox(point), reach);
    const b2Transform in_world(b2Vec2_zero, b2Rot(0.0F));
    pieces_.statics().forEachIn(region, [&](std::size_t, const Piece & piece) { visit(piece, in_world); });
    if (!movables_.empty()) {
      MovableQuery<Visit> query(visit);
      world_.QueryAABB(&query, region);
    }
  }

private:
  template <typename Visit>
  class MovableQuery : public b2QueryCallback
  {
  public:
    explicit MovableQuery(Visit & visit) : visit_(visit) {}
    bool ReportFixture(b2Fixture * fixture) override
    {
      const Piece & piece = pieceOf(*fixture);
      if (piece.owner == Piece::Owner::kModel && fixture->GetBody()->GetType() == b2_dynamicBody) {
        visit_(piece, fixture->GetBody()->GetTransform());
      }
      return true;
    }

  private:
    Visit & visit_;
  };

  struct Participant
  {
    b2Body * body;
    double outer_radius;                 ///< m
    std::optional<b2AABB> surroundings;  ///< whose static pieces Box2D has
  };
  struct Movable
  {
    Participant participant;
    std::size_t model;
  };
  struct Car
  {
    Participant participant;
    CarMotion placed;
  };

  static b2AABB squareAround(const b2Vec2 & centre, double half_width);

  void setMotion(std::size_t model, const ModelMotion & motion);
  void addBodies();
  b2Body * addMovable(const ModelDescription & model, const ModelBody & start);
  void addPieces(const std::vector<Piece> & pieces);
  void surroundParticipants(double travel);
  void surround(Participant & participant, double travel);
  void addGroundFriction();

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
  std::vector<Movable> movables_;
  std::vector<Car> cars_;
  std::size_t layers_added_{0};
  std::vector<bool> static_added_;  ///< by index in StaticPieces
  bool is_pristine_{true};
  bool is_awake_{false};  ///< models wake and fall asleep in steps, or when they are put somewhere
};
}  // namespace f1tenth_sim2d
