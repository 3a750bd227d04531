#include "core/contacts/collision_world.h"

#include <algorithm>
#include <cmath>

#include "core/contacts/ground_friction.h"
#include "core/contacts/piece_extent.h"
#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;
constexpr double kSubstepTravel = 0.005;  // m, so that even thin bodies cannot be passed through
constexpr double kStruckTravel = 0.5;     // m, the farthest that something struck moves in the same step
constexpr double kSurroundings = 0.5;     // m, beyond what is needed now

void addFixture(b2Body & body, const Piece & piece)
{
  b2FixtureDef definition;
  definition.shape = &piece.boxShape();
  definition.userData.pointer = reinterpret_cast<std::uintptr_t>(&piece);
  body.CreateFixture(&definition);
}

/// A body about its centre of mass that can move; kg, kg m^2.
b2Body * createBody(b2World & world, b2BodyDef definition, double mass, double inertia)
{
  definition.type = b2_dynamicBody;
  b2Body * body = world.CreateBody(&definition);
  const b2MassData data{static_cast<float>(mass), b2Vec2_zero, toBoxSquared(inertia)};
  body->SetMassData(&data);
  return body;
}
}  // namespace

bool CollisionWorld::PieceFilter::ShouldCollide(b2Fixture * a, b2Fixture * b)
{
  return canTouch(pieceOf(*a), pieceOf(*b));
}

CollisionWorld::CollisionWorld(const WorldDescription & world, const WorldPieces & pieces)
: description_(world), pieces_(pieces)
{
  world_.SetContactFilter(&filter_);
  world_.SetContactListener(&recorder_);
  // Substeps keep a car from passing through a wall; see docs/core.md.
  world_.SetContinuousPhysics(false);
  addBodies();
  know(pieces.whole());
  addMovablePieces(known_.front());
  addGroundFriction();
}

void CollisionWorld::addBodies()
{
  b2BodyDef definition;
  static_body_ = world_.CreateBody(&definition);
  for (std::size_t i = 0; i < description_.models.size(); ++i) {
    const ModelDescription & model = description_.models[i];
    b2Body * body = model.is_static ? static_body_ : addMovable(model, pieces_.bodies()[i]);
    model_bodies_.push_back(body);
    have_moved_.push_back(false);
    if (!model.is_static) {
      movables_.push_back({{body, outerRadius(wholePieces(i)), {}}, i});
    }
  }
}

b2Body * CollisionWorld::addMovable(const ModelDescription & model, const ModelBody & start)
{
  b2BodyDef definition;
  definition.position = toBox(Transform2(start.frame).apply(start.centre_of_mass));
  definition.angle = static_cast<float>(start.frame.yaw);
  definition.awake = false;
  return createBody(world_, definition, model.mass, model.inertia_zz);
}

std::vector<Piece> CollisionWorld::wholePieces(std::size_t model) const
{
  const auto [first, end] = pieces_.whole().ofMovable(model);
  return {first, end};
}

void CollisionWorld::know(const PieceSet & pieces)
{
  known_.push_back({&pieces, std::vector<bool>(pieces.fixedCount()), false});
}

void CollisionWorld::addMovablePieces(Known & known)
{
  known.in_use = true;
  for (const Piece & piece : known.pieces->movable()) {
    addFixture(*model_bodies_[piece.body], piece);
  }
}

void CollisionWorld::addGroundFriction()
{
  const double ground = groundFriction(description_);
  for (const Movable & movable : movables_) {
    const ModelDescription & model = description_.models[movable.model];
    const double weight = model.mass * description_.gravity;
    addFrictionJoint(*static_body_, *movable.participant.body, wholePieces(movable.model), ground, weight);
  }
}

void CollisionWorld::prepareFor(const CarBody & car)
{
  cars_.reserve(cars_.size() + 1);
  for (const PieceSet * layer : car.layers) {
    const auto is_it = [&](const Known & known) { return known.pieces == layer; };
    if (std::none_of(known_.begin(), known_.end(), is_it)) {
      know(*layer);
    }
  }
}

void CollisionWorld::add(CarBody & car) noexcept
{
  for (Known & known : known_) {
    if (!known.in_use && std::find(car.layers.begin(), car.layers.end(), known.pieces) != car.layers.end()) {
      addMovablePieces(known);
    }
  }
  b2BodyDef definition;
  definition.allowSleep = false;
  definition.enabled = false;
  definition.userData.pointer = reinterpret_cast<std::uintptr_t>(&car);
  b2Body * body = createBody(world_, definition, car.mass, car.inertia);
  for (const Piece & piece : car.pieces) {
    addFixture(*body, piece);
  }
  car.participant.body = body;
  car.participant.surroundings.reset();
  car.contacts.clear();
  cars_.push_back(&car);
}

void CollisionWorld::place(CarBody & car, const PlanarMotion & motion)
{
  b2Body * body = car.participant.body;
  is_pristine_ = false;
  car.placed = motion;
  body->SetTransform(toBox(motion.pose.position()), static_cast<float>(motion.pose.yaw));
  if (!body->IsEnabled()) {
    body->SetEnabled(true);
  }
  body->SetLinearVelocity(toBox(motion.velocity));
  body->SetAngularVelocity(static_cast<float>(motion.yaw_rate));
}

void CollisionWorld::remove(CarBody & car)
{
  if (car.participant.body->IsEnabled()) {
    car.participant.body->SetEnabled(false);
  }
}

void CollisionWorld::step(double dt, double travel)
{
  is_pristine_ = false;
  surroundParticipants(travel);
  recorder_.beginStep();
  for (CarBody * car : cars_) {
    car->contacts.clear();
  }
  const int substeps = std::max(1, static_cast<int>(std::ceil(travel / kSubstepTravel)));
  for (int i = 0; i < substeps; ++i) {
    recorder_.beginSubstep();
    world_.Step(static_cast<float>(dt / substeps), kVelocityIterations, kPositionIterations);
  }
  is_awake_ = false;
  for (const Movable & movable : movables_) {
    if (movable.participant.body->IsAwake()) {
      is_awake_ = true;
      have_moved_[movable.model] = true;
    }
  }
}

void CollisionWorld::surroundParticipants(double travel)
{
  for (CarBody * car : cars_) {
    if (car->participant.body->IsEnabled()) {
      surround(car->participant, travel);
    }
  }
  // Including those asleep: they may be struck in this very step.
  for (Movable & movable : movables_) {
    surround(movable.participant, travel);
  }
}

void CollisionWorld::surround(Participant & participant, double travel)
{
  const b2Vec2 & centre = participant.body->GetPosition();
  const double reach = participant.outer_radius + travel + kStruckTravel;
  std::optional<b2AABB> & region = participant.surroundings;
  if (region && region->Contains(squareAround(centre, reach))) {
    return;
  }
  region = squareAround(centre, reach + kSurroundings);
  for (Known & known : known_) {
    if (!known.in_use) {
      continue;
    }
    known.pieces->forEachFixedIn(*region, [&](std::size_t index, const Piece & piece) {
      if (!known.has_fixed[index]) {
        known.has_fixed[index] = true;
        addFixture(*static_body_, piece);
      }
    });
  }
}

b2AABB CollisionWorld::squareAround(const b2Vec2 & centre, double half_width)
{
  const b2Vec2 half(toBox(half_width), toBox(half_width));
  return {centre - half, centre + half};
}

// Relative to where Box2D started, in its own precision: a car at rest is not moved by rounding.
ContactEffect CollisionWorld::effect(const CarBody & car)
{
  const b2Body & body = *car.participant.body;
  const PlanarMotion & placed = car.placed;
  const Vec2 start = fromBox(toBox(placed.pose.position()));
  const Vec2 velocity = fromBox(toBox(placed.velocity));
  const Vec2 end = fromBox(body.GetPosition());
  const Vec2 end_velocity = fromBox(body.GetLinearVelocity());
  ContactEffect effect;
  effect.displacement = {
    end.x - start.x, end.y - start.y, static_cast<double>(body.GetAngle()) - static_cast<float>(placed.pose.yaw)};
  effect.velocity_change = end_velocity - velocity;
  effect.yaw_rate_change = static_cast<double>(body.GetAngularVelocity()) - static_cast<float>(placed.yaw_rate);
  return effect;
}

double CollisionWorld::movableTravel(double dt) const
{
  if (!is_awake_) {
    return 0.0;
  }
  double travel = 0.0;
  for (const Movable & movable : movables_) {
    const b2Body & body = *movable.participant.body;
    if (body.IsAwake()) {
      const double speed = fromBox(body.GetLinearVelocity().Length());
      const double turning = std::abs(body.GetAngularVelocity()) * movable.participant.outer_radius;
      travel = std::max(travel, (speed + turning) * dt);
    }
  }
  return travel;
}

Pose2 CollisionWorld::modelPose(std::size_t model) const
{
  const ModelDescription & description = description_.models[model];
  const b2Body & body = *model_bodies_[model];
  if (description.is_static) {
    return planar(description.pose);
  }
  const ModelBody & start = pieces_.bodies()[model];
  if (!have_moved_[model]) {
    return start.frame;
  }
  const Vec2 position = fromBox(body.GetPosition());
  const Pose2 centre{position.x, position.y, body.GetAngle()};
  return chain(centre, {-start.centre_of_mass.x, -start.centre_of_mass.y, 0.0});
}

ModelState CollisionWorld::modelState(std::size_t model) const
{
  ModelState state{modelPose(model), {}, 0.0};
  const b2Body & body = *model_bodies_[model];
  if (!description_.models[model].is_static) {
    const Vec2 from_centre = state.pose.position() - fromBox(body.GetPosition());
    state.yaw_rate = body.GetAngularVelocity();
    state.velocity = velocityAt(fromBox(body.GetLinearVelocity()), state.yaw_rate, from_centre);
  }
  return state;
}

void CollisionWorld::placeModel(std::size_t model, const ModelState & state)
{
  const Vec2 arm = Transform2(state.pose).rotate(pieces_.bodies()[model].centre_of_mass);
  const Vec2 velocity = velocityAt(state.velocity, state.yaw_rate, arm);
  setMotion(
    model, {toBox(state.pose.position() + arm), static_cast<float>(state.pose.yaw), toBox(velocity),
            static_cast<float>(state.yaw_rate), true, true, true});
}

std::vector<ModelMotion> CollisionWorld::motions() const
{
  std::vector<ModelMotion> motions(model_bodies_.size());
  for (const Movable & movable : movables_) {
    const b2Body & body = *movable.participant.body;
    motions[movable.model] = {
      body.GetPosition(),
      body.GetAngle(),
      body.GetLinearVelocity(),
      body.GetAngularVelocity(),
      body.IsAwake(),
      have_moved_[movable.model],
      true};
  }
  return motions;
}

void CollisionWorld::setMotions(const std::vector<ModelMotion> & motions)
{
  for (std::size_t model = 0; model < motions.size(); ++model) {
    if (motions[model].known) {
      setMotion(model, motions[model]);
    }
  }
}

void CollisionWorld::setMotion(std::size_t model, const ModelMotion & motion)
{
  b2Body & body = *model_bodies_[model];
  is_pristine_ = false;
  have_moved_[model] = motion.moved;
  body.SetTransform(motion.centre, motion.angle);
  body.SetAwake(motion.awake);
  if (motion.awake) {
    body.SetLinearVelocity(motion.velocity);
    body.SetAngularVelocity(motion.yaw_rate);
    is_awake_ = true;
  }
}
}  // namespace f1tenth_sim2d
