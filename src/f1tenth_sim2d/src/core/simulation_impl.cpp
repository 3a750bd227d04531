#include "simulation_impl.h"

#include <algorithm>
#include <sstream>

#include "clearance.h"
#include "f1tenth_sim2d/errors.h"
#include "noise.h"
#include "planar_pose.h"
#include "sim_time.h"
#include "validation.h"

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
  pieces_(world_),
  collisions_(std::make_unique<CollisionWorld>(world_, pieces_))
{
}

CarIndex Simulation::Impl::addCar(
  const CarDescription & description, const VehicleParameters & parameters, const Pose2 & pose)
{
  validate(description, pose);
  for (const auto & other : cars_) {
    if (other->description().name == description.name) {
      throw Error(description.name + ": there is already a car of this name");
    }
  }
  const CarIndex index = cars_.size();
  auto car = std::make_unique<Car>(index, description, parameters, pose, options_.seed, pieces_);
  car->restart(time_);
  collisions_->addLayers(car->layerCount());
  std::vector<PlacedCar> places = placedCars(cars_);
  places.push_back(car->placed());
  refuseOccupiedPlace(places, index, description.name + ": the start pose " + text(pose));

  collisions_->addCar(car->body());
  encounters_.addCar();
  for (LidarScene & scene : scenes_) {
    scene.addCar(description);
  }
  cars_.push_back(std::move(car));
  addLidars(*cars_.back());
  moving_poses_are_current_ = false;
  return index;
}

void Simulation::Impl::placeCar(CarIndex index, const Pose2 & pose)
{
  const CarDescription & description = car(index).description();
  validate(description, pose);
  std::vector<PlacedCar> places = placedCars(cars_);
  places[index].pose = compose(pose, {car(index).parameters().l_r, 0.0, 0.0});
  refuseOccupiedPlace(places, index, description.name + ": the pose " + text(pose));
  car(index).place(pose);
  encounters_.restart();
  moving_poses_are_current_ = false;
}

void Simulation::Impl::refuseOccupiedPlace(
  const std::vector<PlacedCar> & places, CarIndex own, const std::string & what) const
{
  if (const Piece * piece = firstOverlap(places, own, *collisions_)) {
    throw Error(what + " is not free: it overlaps " + nameOf(*piece));
  }
}

std::string Simulation::Impl::nameOf(const Piece & piece) const
{
  if (piece.owner == Piece::Owner::kCar) {
    return "car " + cars_[piece.body]->description().name;
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
  for (const auto & car : cars_) {
    scene.addCar(car->description());
  }
  return scenes_.size() - 1;
}

void Simulation::Impl::step()
{
  for (const auto & car : cars_) {
    car->predict(time_, dt_);
  }
  const bool touched = encounters_.advance(cars_, *collisions_, dt_);
  if (touched) {
    logContacts();
  }
  time_ += step_length_;
  for (const auto & car : cars_) {
    car->commit(time_, dt_);
  }
  moving_poses_are_current_ = false;
}

void Simulation::Impl::logContacts()
{
  for (CarIndex i = 0; i < cars_.size(); ++i) {
    Car & car = *cars_[i];
    for (const StepContact & contact : collisions_->contacts(i)) {
      car.contactLog().add(
        contact, dt_, [&](const StepContact & step, Contact & report) { describe(car, step, report); });
    }
  }
}

void Simulation::Impl::describe(const Car & car, const StepContact & step, Contact & contact) const
{
  const bool is_car = step.other_owner == Piece::Owner::kCar;
  const CarDescription * other_car = is_car ? &cars_[step.other_body]->description() : nullptr;
  const ModelDescription * model = is_car ? nullptr : &world_.models[step.other_body];
  const std::vector<Solid> & solids = is_car ? other_car->solids : model->solids;
  contact.own_collision = car.description().solids[step.own_solid].name;
  contact.other_collision = solids[step.other_solid].name;
  contact.other_model = is_car ? other_car->name : model->name;
}

// The same calls in the same order as from fresh, so that Box2D's inner order is the same, too.
void Simulation::Impl::reset()
{
  time_ = 0;
  collisions_ = std::make_unique<CollisionWorld>(world_, pieces_);
  for (const auto & car : cars_) {
    car->restart(time_);
    collisions_->addLayers(car->layerCount());
    collisions_->addCar(car->body());
  }
  encounters_.restart();
  moving_poses_are_current_ = false;
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
  for (const auto & car : cars_) {
    moving_poses_.cars.emplace_back(car->pose());
  }
  moving_poses_are_current_ = true;
  return moving_poses_;
}

void Simulation::Impl::scan(CarIndex index, std::size_t lidar, bool noisy, float * ranges)
{
  Car & own = car(index);
  LidarSensor & sensor = own.lidars().at(lidar);
  LidarScene & scene = scenes_[sensor.scene()];
  if (noisy) {
    const std::uint64_t key =
      noiseKey(options_.seed, index, NoiseStream::kLidar, lidar, static_cast<std::uint64_t>(time_));
    sensor.noisyScan(scene, index, own.pose(), movingPoses(), key, ranges);
  } else {
    sensor.scan(scene, index, own.pose(), movingPoses(), ranges);
  }
}

ImuSample Simulation::Impl::imu(CarIndex index) const
{
  const CarState & state = car(index).state();
  ImuSample sample{state.pose.yaw, state.yaw_rate, state.acceleration};
  if (const auto & imu = car(index).description().imu) {
    const std::uint64_t key = noiseKey(options_.seed, index, NoiseStream::kImu, 0, static_cast<std::uint64_t>(time_));
    sample.yaw_rate += imu->yaw_rate_noise_stddev * gaussian(key, 0);
    sample.acceleration.x += imu->acceleration_noise_stddev * gaussian(key, 1);
    sample.acceleration.y += imu->acceleration_noise_stddev * gaussian(key, 2);
  }
  return sample;
}
}  // namespace f1tenth_sim2d
