#include "core/simulation/simulation_impl.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

#include "core/contacts/clearance.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"
#include "core/simulation/encounters.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/occupied_place.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kFarthest = 1e6;  // m; no world is that large, and an endless ray would not know when to end

/// "walls::Wall_3" of "walls::Wall_3::Wall_3_Collision": what a person knows the solid by.
std::string withoutCollision(const std::string & scoped_name)
{
  const std::size_t end = scoped_name.rfind("::");
  return end == std::string::npos ? scoped_name : scoped_name.substr(0, end);
}

std::string text(const Pose2 & pose)
{
  std::ostringstream stream;
  stream << "(" << pose.x << ", " << pose.y << ", " << pose.yaw << ")";
  return stream.str();
}
}  // namespace

Simulation::Impl::Impl(std::shared_ptr<const WorldGeometry> world, const SimulationOptions & options)
: geometry_(std::move(world)),
  options_(validated(options)),
  step_length_(fromSeconds(options.physics_step)),
  dt_(toSeconds(step_length_)),
  collisions_(std::make_unique<CollisionWorld>(geometry_->world(), geometry_->pieces()))
{
  for (const ModelDescription & model : geometry_->world().models) {
    start_poses_.push_back(model.pose);
  }
}

CarId Simulation::Impl::addCar(
  const CarDescription & description, const VehicleParameters & parameters, const Pose2 & pose)
{
  validate(description, pose);
  validate(parameters, description.name);
  refuseTakenName(description.name);
  const CarId id = registry_.nextId();
  auto car = std::make_unique<RegisteredCar>(
    id, registry_.freeNoiseStream(), description, parameters, pose, options_.seed, geometry_->pieces());
  car->car.restart(time_);
  std::vector<PlacedCar> places = placedCars(cars());
  places.push_back(car->placed());
  refuseOccupiedPlace(places, cars().size(), description.name + ": the start pose " + text(pose));
  letIn(std::move(car));
  return id;
}

void Simulation::Impl::letIn(std::unique_ptr<RegisteredCar> car)
{
  registry_.reserve();
  collisions_->prepareFor(*car->body);
  car->lidars = makeLidars(*car, *geometry_, scenes_);
  std::vector<MovingSection> sections;
  for (LidarScene & scene : scenes_) {
    scene.reserveCar();
    sections.push_back(scene.sectionOf(car->description.solids));
  }
  // Nothing fails from here on, so that a car is there wholly or not at all.
  collisions_->add(*car->body);
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    scenes_[i].addCar(car->id, std::move(sections[i]));
  }
  registry_.add(std::move(car));
}

void Simulation::Impl::refuseTakenName(const std::string & name) const
{
  for (const auto & car : cars()) {
    if (car->description.name == name) {
      throw Error(name + ": there is already a car of this name");
    }
  }
  for (const ModelDescription & model : world().models) {
    if (model.name == name) {
      throw Error(name + ": there is already a model of this name");
    }
  }
}

void Simulation::Impl::removeCar(CarId id)
{
  registry_.indexOf(id);
  const std::vector<ModelMotion> motions = collisions_->motions();
  auto collisions = emptyCollisions();
  registry_.remove(id);
  for (LidarScene & scene : scenes_) {
    scene.removeCar(id);
  }
  enter(std::move(collisions));
  collisions_->setMotions(motions);
}

void Simulation::Impl::placeCar(CarId id, const Pose2 & pose, const Vec2 & velocity, double yaw_rate)
{
  const std::size_t index = registry_.indexOf(id);
  RegisteredCar & own = *cars()[index];
  validate(own.description, pose);
  validate(ModelState{pose, velocity, yaw_rate}, own.description.name);
  std::vector<PlacedCar> places = placedCars(cars());
  places[index].pose = chain(pose, {own.car.parameters().l_r, 0.0, 0.0});
  refuseOccupiedPlace(places, index, own.description.name + ": the pose " + text(pose));
  own.car.place(pose, velocity, yaw_rate);
  forgetSurroundings(cars());
}

void Simulation::Impl::addModel(const ModelDescription & model)
{
  refuseTakenName(model.name);
  validate(model, world().file);
  WorldDescription changed = world();
  changed.models.push_back(model);
  std::vector<ModelMotion> motions = collisions_->motions();
  motions.emplace_back();
  start_poses_.reserve(start_poses_.size() + 1);
  changeWorld(std::move(changed), motions);
  start_poses_.push_back(model.pose);
}

void Simulation::Impl::removeModel(std::size_t index)
{
  std::vector<ModelMotion> motions = collisions_->motions();
  static_cast<void>(motions.at(index));  // throws before anything is changed
  const auto place = static_cast<std::ptrdiff_t>(index);
  WorldDescription changed = world();
  changed.models.erase(changed.models.begin() + place);
  motions.erase(motions.begin() + place);
  changeWorld(std::move(changed), motions);
  start_poses_.erase(start_poses_.begin() + place);
}

void Simulation::Impl::placeModel(std::size_t index, const ModelState & state)
{
  const ModelDescription & model = world().models.at(index);
  validate(state, model.name);
  if (model.is_static) {
    WorldDescription changed = world();
    changed.models[index].pose =
      Pose3(state.pose.x, state.pose.y, 0.0, 0.0, 0.0, state.pose.yaw) * withoutPlanar(model.pose);
    changeWorld(std::move(changed), collisions_->motions());
    static_models_moved_ = true;
    return;
  }
  collisions_->placeModel(index, state);
  forgetSurroundings(cars());
}

// Another world around the cars; they and the models that have motions stay where they are.
void Simulation::Impl::changeWorld(WorldDescription world, const std::vector<ModelMotion> & motions)
{
  auto geometry = std::make_shared<const WorldGeometry>(std::move(world));
  auto collisions = std::make_unique<CollisionWorld>(geometry->world(), geometry->pieces());
  std::vector<std::unique_ptr<CarBody>> bodies;
  std::vector<Lidars> lidars;
  Scenes scenes;
  for (const auto & car : cars()) {
    bodies.push_back(car->makeBody(geometry->pieces()));
    collisions->prepareFor(*bodies.back());
    lidars.push_back(makeLidars(*car, *geometry, scenes));
  }
  // Nothing fails from here on.
  for (std::size_t i = 0; i < cars().size(); ++i) {
    cars()[i]->body.swap(bodies[i]);
    cars()[i]->lidars.swap(lidars[i]);
  }
  scenes_.swap(scenes);
  enter(std::move(collisions));
  collisions_->setMotions(motions);
  geometry_ = std::move(geometry);
}

std::unique_ptr<CollisionWorld> Simulation::Impl::emptyCollisions() const
{
  auto collisions = std::make_unique<CollisionWorld>(geometry_->world(), geometry_->pieces());
  for (const auto & car : cars()) {
    collisions->prepareFor(*car->body);
  }
  return collisions;
}

void Simulation::Impl::enter(std::unique_ptr<CollisionWorld> collisions) noexcept
{
  collisions_ = std::move(collisions);
  for (const auto & car : cars()) {
    collisions_->add(*car->body);
  }
  forgetSurroundings(cars());
}

void Simulation::Impl::returnStaticModels()
{
  if (!static_models_moved_) {
    return;
  }
  WorldDescription changed = world();
  for (std::size_t i = 0; i < changed.models.size(); ++i) {
    changed.models[i].pose = start_poses_[i];
  }
  changeWorld(std::move(changed), {});
  static_models_moved_ = false;
}

void Simulation::Impl::refuseOccupiedPlace(
  const std::vector<PlacedCar> & places, std::size_t own, const std::string & what) const
{
  if (const Piece * piece = firstOverlap(places, own, *collisions_)) {
    throw OccupiedPlace(what + " is not free: it overlaps " + nameOf(*piece));
  }
}

std::string Simulation::Impl::nameOf(const Piece & piece) const
{
  if (piece.owner == Piece::Owner::kCar) {
    return "car " + car(CarId{piece.body}).description.name;
  }
  return "model " + withoutCollision(world().models[piece.body].solids[piece.solid].name);
}

Simulation::Impl::Lidars Simulation::Impl::makeLidars(
  const RegisteredCar & car, const WorldGeometry & world, Scenes & scenes) const
{
  Lidars lidars;
  for (const LidarDescription & lidar : car.description.lidars) {
    lidars.emplace_back(lidar, sceneAt(lidar.pose.position.z(), cars(), world, scenes));
  }
  return lidars;
}

const LidarScene & Simulation::Impl::sceneAt(
  double height, const Cars & seen, const WorldGeometry & world, Scenes & scenes)
{
  const auto found = std::find_if(
    scenes.begin(), scenes.end(), [&](const LidarScene & scene) { return scene.world().height() == height; });
  if (found != scenes.end()) {
    return *found;
  }
  LidarScene scene(world.sectionAt(height));
  for (const auto & car : seen) {
    scene.reserveCar();
    scene.addCar(car->id, scene.sectionOf(car->description.solids));
  }
  return scenes.emplace_back(std::move(scene));
}

void Simulation::Impl::step()
{
  for (const auto & car : cars()) {
    car->car.predict(time_, dt_);
  }
  const bool touched = applyContacts(cars(), *collisions_, dt_);
  if (touched) {
    logContacts();
  }
  time_ += step_length_;
  for (const auto & car : cars()) {
    car->car.commit(time_, dt_);
  }
}

void Simulation::Impl::logContacts()
{
  for (const auto & car : cars()) {
    for (const StepContact & contact : car->body->contacts) {
      car->contacts.add(
        contact, dt_, [&](const StepContact & step, Contact & report) { describe(*car, step, report); });
    }
  }
}

void Simulation::Impl::describe(const RegisteredCar & own, const StepContact & step, Contact & contact) const
{
  const bool is_car = step.other_owner == Piece::Owner::kCar;
  const CarDescription * other_car = is_car ? &car(CarId{step.other_body}).description : nullptr;
  const ModelDescription * model = is_car ? nullptr : &world().models[step.other_body];
  const std::vector<Solid> & solids = is_car ? other_car->solids : model->solids;
  contact.own_collision = own.description.solids[step.own_solid].name;
  contact.other_collision = solids[step.other_solid].name;
  contact.other_model = is_car ? other_car->name : model->name;
}

void Simulation::Impl::reset()
{
  time_ = 0;
  resetPoses();
}

void Simulation::Impl::resetPoses()
{
  returnStaticModels();
  for (const auto & car : cars()) {
    car->car.restart(time_);
    car->contacts.clear();
  }
  // The same calls in the same order as from fresh, so that Box2D's inner order is the same, too.
  if (collisions_->isPristine()) {
    forgetSurroundings(cars());
  } else {
    enter(emptyCollisions());
  }
}

Pose2 Simulation::Impl::ofModel(std::size_t model) const
{
  return collisions_->modelPose(model);
}

Pose2 Simulation::Impl::ofCar(CarId id) const
{
  return car(id).car.pose();
}

void Simulation::Impl::scan(CarId id, std::size_t lidar, bool noisy, float * ranges) const
{
  const RegisteredCar & own = car(id);
  std::optional<std::uint64_t> noise_key;
  if (noisy) {
    noise_key =
      noiseKey(options_.seed, own.noise_stream, NoiseStream::kLidar, lidar, static_cast<std::uint64_t>(time_));
  }
  own.lidars.at(lidar).scan(id, own.car.pose(), *this, noise_key, ranges);
}

void Simulation::Impl::castRays(CarId id, const RayFan & fan, double * ranges) const
{
  const Pose2 origin = chain(car(id).car.pose(), fan.origin);
  const LidarScene & scene = [&]() -> const LidarScene & {
    const std::lock_guard<std::mutex> lock(scenes_mutex_);
    return sceneAt(fan.height, cars(), *geometry_, scenes_);
  }();
  LidarDescription ray;
  ray.beam_count = 1;
  const double range_max = std::min(kFarthest, fan.range_max);
  const ScanSpaces::Loan space = scene.world().spacesFor(ray).borrow();
  for (std::size_t i = 0; i < fan.directions.size(); ++i) {
    space->raster.begin({origin.x, origin.y, origin.yaw + fan.directions[i]}, range_max);
    scene.draw(id, *this, space->raster, space->drawn);
    const double range = 1.0 / space->raster.inverseRanges()[0];
    ranges[i] = range < fan.range_max ? range : std::numeric_limits<double>::infinity();
  }
}

double Simulation::Impl::noise(CarId id, const std::string & sensor, std::uint64_t index) const
{
  const auto now = static_cast<std::uint64_t>(time_);
  return gaussian(noiseKey(options_.seed, car(id).noise_stream, NoiseStream::kNamedSensor, hashOf(sensor), now), index);
}

ImuSample Simulation::Impl::imu(CarId id) const
{
  const RegisteredCar & own = car(id);
  const CarState state = own.car.state();
  ImuSample sample{state.pose.yaw, state.yaw_rate, state.acceleration};
  if (const auto & imu = own.description.imu) {
    const std::uint64_t key =
      noiseKey(options_.seed, own.noise_stream, NoiseStream::kImu, 0, static_cast<std::uint64_t>(time_));
    sample.yaw_rate += imu->yaw_rate_noise_stddev * gaussian(key, 0);
    sample.acceleration.x += imu->acceleration_noise_stddev * gaussian(key, 1);
    sample.acceleration.y += imu->acceleration_noise_stddev * gaussian(key, 2);
  }
  return sample;
}
}  // namespace f1tenth_sim2d
