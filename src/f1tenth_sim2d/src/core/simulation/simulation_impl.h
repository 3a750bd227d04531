#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/contacts/collision_world.h"
#include "core/lidar/lidar_scene.h"
#include "core/simulation/car_registry.h"
#include "core/simulation/world_geometry.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
class Simulation::Impl : private MovingPoses
{
public:
  Impl(std::shared_ptr<const WorldGeometry> world, const SimulationOptions & options);

  CarId addCar(const CarDescription & description, const VehicleParameters & parameters, const Pose2 & pose);
  void removeCar(CarId id);
  void placeCar(CarId id, const Pose2 & pose, const Vec2 & velocity, double yaw_rate);
  void addModel(const ModelDescription & model);
  void removeModel(std::size_t index);
  void placeModel(std::size_t index, const ModelState & state);
  void step();
  void reset();
  void resetPoses();
  void scan(CarId id, std::size_t lidar, bool noisy, float * ranges) const;
  void castRays(CarId id, const RayFan & fan, double * ranges) const;
  double noise(CarId id, const std::string & sensor, std::uint64_t index) const;
  ImuSample imu(CarId id) const;

  RegisteredCar & car(CarId id) const { return registry_.at(id); }
  const CarRegistry & registry() const { return registry_; }
  const WorldDescription & world() const { return geometry_->world(); }
  const CollisionWorld & collisions() const { return *collisions_; }
  SimTime time() const { return time_; }
  SimTime stepLength() const { return step_length_; }

private:
  using Scenes = std::deque<LidarScene>;
  using Lidars = std::vector<LidarSensor>;

  const Cars & cars() const { return registry_.cars(); }
  Pose2 ofModel(std::size_t model) const override;
  Pose2 ofCar(CarId car) const override;
  static const LidarScene & sceneAt(double height, const Cars & seen, const WorldGeometry & world, Scenes & scenes);
  Lidars makeLidars(const RegisteredCar & car, const WorldGeometry & world, Scenes & scenes) const;
  void letIn(std::unique_ptr<RegisteredCar> car);
  void refuseOccupiedPlace(const std::vector<PlacedCar> & places, std::size_t own, const std::string & what) const;
  void refuseTakenName(const std::string & name) const;
  std::string nameOf(const Piece & piece) const;
  void logContacts();
  void describe(const RegisteredCar & car, const StepContact & step, Contact & contact) const;
  void changeWorld(WorldDescription world, const std::vector<ModelMotion> & motions);
  /// Without cars, but with room for all of them.
  std::unique_ptr<CollisionWorld> emptyCollisions() const;
  void enter(std::unique_ptr<CollisionWorld> collisions) noexcept;
  void returnStaticModels();

  std::shared_ptr<const WorldGeometry> geometry_;
  SimulationOptions options_;
  SimTime step_length_;
  double dt_;  ///< s
  SimTime time_{0};
  std::vector<Pose3> start_poses_;  ///< of the models; static ones may have been put elsewhere
  bool static_models_moved_{false};
  std::unique_ptr<CollisionWorld> collisions_;
  CarRegistry registry_;
  mutable std::mutex scenes_mutex_;  ///< of const functions that add one
  mutable Scenes scenes_;
};
}  // namespace f1tenth_sim2d
