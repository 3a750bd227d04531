#include "core/simulation/simulation_impl.h"

#include <algorithm>
#include <sstream>

#include "core/contacts/clearance.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"
#include "core/simulation/validation.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
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

Simulation::Impl::Impl(const WorldDescription & world, const SimulationOptions & options)
: world_(validated(world)),
  options_(validated(options)),
  step_length_(fromSeconds(options.physics_step)),
  dt_(toSeconds(step_length_)),
  pieces_(std::in_place, world_),
  collisions_(std::make_unique<CollisionWorld>(world_, *pieces_))
{
  for (const ModelDescription & model : world_.models) {
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
  const std::size_t index = cars().size();
  auto car =
    std::make_unique<Car>(index, registry_.freeNoiseStream(), description, parameters, pose, options_.seed, *pieces_);
  car->restart(time_);
  collisions_->addLayers(car->layerCount());
  std::vector<PlacedCar> places = placedCars(cars());
  places.push_back(car->placed());
  refuseOccupiedPlace(places, index, description.name + ": the start pose " + text(pose));

  collisions_->addCar(car->body());
  encounters_.addCar();
  for (LidarScene & scene : scenes_) {
    scene.addCar(description);
  }
  registry_.add(std::move(car));
  addLidars(registry_.at(id));
  moving_poses_are_current_ = false;
  return id;
}

void Simulation::Impl::refuseTakenName(const std::string & name) const
{
  for (const auto & car : cars()) {
    if (car->description().name == name) {
      throw Error(name + ": there is already a car of this name");
    }
  }
  for (const ModelDescription & model : world_.models) {
    if (model.name == name) {
      throw Error(name + ": there is already a model of this name");
    }
  }
}

void Simulation::Impl::removeCar(CarId id)
{
  registry_.remove(id);
  rebuild(collisions_->motions());
}

void Simulation::Impl::placeCar(CarId id, const Pose2 & pose, const Vec2 & velocity, double yaw_rate)
{
  const std::size_t index = registry_.indexOf(id);
  Car & car = registry_.at(id);
  const CarDescription & description = car.description();
  validate(description, pose);
  validate(ModelState{pose, velocity, yaw_rate}, description.name);
  std::vector<PlacedCar> places = placedCars(cars());
  places[index].pose = compose(pose, {car.parameters().l_r, 0.0, 0.0});
  refuseOccupiedPlace(places, index, description.name + ": the pose " + text(pose));
  car.place(pose, velocity, yaw_rate);
  encounters_.restart();
  moving_poses_are_current_ = false;
}

void Simulation::Impl::addModel(const ModelDescription & model)
{
  refuseTakenName(model.name);
  validate(model, world_.file);
  std::vector<ModelMotion> motions = collisions_->motions();
  world_.models.push_back(model);
  start_poses_.push_back(model.pose);
  motions.emplace_back();
  rebuild(motions);
}

void Simulation::Impl::removeModel(std::size_t index)
{
  std::vector<ModelMotion> motions = collisions_->motions();
  motions.at(index);
  const auto place = static_cast<std::ptrdiff_t>(index);
  world_.models.erase(world_.models.begin() + place);
  start_poses_.erase(start_poses_.begin() + place);
  motions.erase(motions.begin() + place);
  rebuild(motions);
}

void Simulation::Impl::placeModel(std::size_t index, const ModelState & state)
{
  ModelDescription & model = world_.models.at(index);
  validate(state, model.name);
  if (model.is_static) {
    model.pose =
      ignition::math::Pose3d(state.pose.x, state.pose.y, 0.0, 0.0, 0.0, state.pose.yaw) * withoutPlanar(model.pose);
    static_models_moved_ = true;
    rebuild(collisions_->motions());
    return;
  }
  collisions_->placeModel(index, state);
  encounters_.restart();
  moving_poses_are_current_ = false;
}

// What has been worked out of the world and the cars, for another set of them; everything stays where it is.
void Simulation::Impl::rebuild(const std::vector<ModelMotion> & motions)
{
  collisions_.reset();
  pieces_.emplace(world_);
  for (std::size_t i = 0; i < cars().size(); ++i) {
    cars()[i]->moveInto(i, *pieces_);
  }
  rebuildCollisions();
  collisions_->setMotions(motions);
  rebuildScenes();
}

void Simulation::Impl::rebuildCollisions()
{
  collisions_ = std::make_unique<CollisionWorld>(world_, *pieces_);
  encounters_ = {};
  for (const auto & car : cars()) {
    collisions_->addLayers(car->layerCount());
    collisions_->addCar(car->body());
    encounters_.addCar();
  }
  moving_poses_are_current_ = false;
}

void Simulation::Impl::rebuildScenes()
{
  scenes_.clear();
  for (const auto & car : cars()) {
    car->lidars().clear();
    addLidars(*car);
  }
}

void Simulation::Impl::returnStaticModels()
{
  if (!static_models_moved_) {
    return;
  }
  for (std::size_t i = 0; i < world_.models.size(); ++i) {
    world_.models[i].pose = start_poses_[i];
  }
  rebuild({});
  static_models_moved_ = false;
}

void Simulation::Impl::refuseOccupiedPlace(
  const std::vector<PlacedCar> & places, std::size_t own, const std::string & what) const
{
  if (const Piece * piece = firstOverlap(places, own, *collisions_)) {
    throw Error(what + " is not free: it overlaps " + nameOf(*piece));
  }
}

std::string Simulation::Impl::nameOf(const Piece & piece) const
{
  if (piece.owner == Piece::Owner::kCar) {
    return "car " + cars()[piece.body]->description().name;
  }
  return "model " + withoutCollision(world_.models[piece.body].solids[piece.solid].name);
}

void Simulation::Impl::addLidars(Car & car)
{
  for (const LidarDescription & lidar : car.description().lidars) {
    car.lidars().emplace_back(lidar, sceneAt(lidar.pose.Pos().Z()));
  }
}

std::size_t Simulation::Impl::sceneAt(double height)
{
  const auto found =
    std::find_if(scenes_.begin(), scenes_.end(), [&](const LidarScene & scene) { return scene.height() == height; });
  if (found != scenes_.end()) {
    return found - scenes_.begin();
  }
  LidarScene & scene = scenes_.emplace_back(world_, height);
  for (const auto & car : cars()) {
    scene.addCar(car->description());
  }
  return scenes_.size() - 1;
}

void Simulation::Impl::step()
{
  for (const auto & car : cars()) {
    car->predict(time_, dt_);
  }
  const bool touched = encounters_.advance(cars(), *collisions_, dt_);
  if (touched) {
    logContacts();
  }
  time_ += step_length_;
  for (const auto & car : cars()) {
    car->commit(time_, dt_);
  }
  moving_poses_are_current_ = false;
}

void Simulation::Impl::logContacts()
{
  for (std::size_t i = 0; i < cars().size(); ++i) {
    Car & car = *cars()[i];
    for (const StepContact & contact : collisions_->contacts(i)) {
      car.contactLog().add(
        contact, dt_, [&](const StepContact & step, Contact & report) { describe(car, step, report); });
    }
  }
}

void Simulation::Impl::describe(const Car & car, const StepContact & step, Contact & contact) const
{
  const bool is_car = step.other_owner == Piece::Owner::kCar;
  const CarDescription * other_car = is_car ? &cars()[step.other_body]->description() : nullptr;
  const ModelDescription * model = is_car ? nullptr : &world_.models[step.other_body];
  const std::vector<Solid> & solids = is_car ? other_car->solids : model->solids;
  contact.own_collision = car.description().solids[step.own_solid].name;
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
    car->restart(time_);
  }
  // The same calls in the same order as from fresh, so that Box2D's inner order is the same, too.
  if (collisions_->isPristine()) {
    encounters_.restart();
    moving_poses_are_current_ = false;
  } else {
    rebuildCollisions();
  }
}

const MovingPoses & Simulation::Impl::movingPoses()
{
  if (moving_poses_are_current_) {
    return moving_poses_;
  }
  moving_poses_.models.clear();
  for (std::size_t i = 0; i < world_.models.size(); ++i) {
    if (!world_.models[i].is_static) {
      moving_poses_.models.emplace_back(collisions_->modelPose(i));
    }
  }
  moving_poses_.cars.clear();
  for (const auto & car : cars()) {
    moving_poses_.cars.emplace_back(car->pose());
  }
  moving_poses_are_current_ = true;
  return moving_poses_;
}

void Simulation::Impl::scan(CarId id, std::size_t lidar, bool noisy, float * ranges)
{
  const std::size_t index = registry_.indexOf(id);
  Car & own = *cars()[index];
  LidarSensor & sensor = own.lidars().at(lidar);
  LidarScene & scene = scenes_[sensor.scene()];
  if (noisy) {
    const std::uint64_t key =
      noiseKey(options_.seed, own.noiseStream(), NoiseStream::kLidar, lidar, static_cast<std::uint64_t>(time_));
    sensor.noisyScan(scene, index, own.pose(), movingPoses(), key, ranges);
  } else {
    sensor.scan(scene, index, own.pose(), movingPoses(), ranges);
  }
}

ImuSample Simulation::Impl::imu(CarId id) const
{
  const Car & own = car(id);
  const CarState & state = own.state();
  ImuSample sample{state.pose.yaw, state.yaw_rate, state.acceleration};
  if (const auto & imu = own.description().imu) {
    const std::uint64_t key =
      noiseKey(options_.seed, own.noiseStream(), NoiseStream::kImu, 0, static_cast<std::uint64_t>(time_));
    sample.yaw_rate += imu->yaw_rate_noise_stddev * gaussian(key, 0);
    sample.acceleration.x += imu->acceleration_noise_stddev * gaussian(key, 1);
    sample.acceleration.y += imu->acceleration_noise_stddev * gaussian(key, 2);
  }
  return sample;
}
}  // namespace f1tenth_sim2d
