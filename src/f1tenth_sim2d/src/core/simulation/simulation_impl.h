#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/contacts/collision_world.h"
#include "core/contacts/world_pieces.h"
#include "core/lidar/lidar_scene.h"
#include "core/simulation/car_registry.h"
#include "core/simulation/encounters.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
class Simulation::Impl
{
public:
  Impl(const WorldDescription & world, const SimulationOptions & options);

  CarId addCar(const CarDescription & description, const VehicleParameters & parameters, const Pose2 & pose);
  void removeCar(CarId id);
  void placeCar(CarId id, const Pose2 & pose, const Vec2 & velocity, double yaw_rate);
  void addModel(const ModelDescription & model);
  void removeModel(std::size_t index);
  void placeModel(std::size_t index, const ModelState & state);
  void step();
  void reset();
  void resetPoses();
  void scan(CarId id, std::size_t lidar, bool noisy, float * ranges);
  ImuSample imu(CarId id) const;

  Car & car(CarId id) { return registry_.at(id); }
  const Car & car(CarId id) const { return registry_.at(id); }
  const CarRegistry & registry() const { return registry_; }
  const WorldDescription & world() const { return world_; }
  const CollisionWorld & collisions() const { return *collisions_; }
  SimTime time() const { return time_; }
  SimTime stepLength() const { return step_length_; }

private:
  const Cars & cars() const { return registry_.cars(); }
  std::size_t sceneAt(double height);
  void addLidars(Car & car);
  void refuseOccupiedPlace(const std::vector<PlacedCar> & places, std::size_t own, const std::string & what) const;
  void refuseTakenName(const std::string & name) const;
  std::string nameOf(const Piece & piece) const;
  void logContacts();
  void describe(const Car & car, const StepContact & step, Contact & contact) const;
  const MovingPoses & movingPoses();
  void rebuild(const std::vector<ModelMotion> & motions);
  void rebuildCollisions();
  void rebuildScenes();
  void returnStaticModels();

  WorldDescription world_;
  SimulationOptions options_;
  SimTime step_length_;
  double dt_;  ///< s
  SimTime time_{0};
  std::vector<ignition::math::Pose3d> start_poses_;  ///< of the models; static ones may have been put elsewhere
  bool static_models_moved_{false};
  std::optional<WorldPieces> pieces_;  ///< always there, made anew when the world changes
  std::unique_ptr<CollisionWorld> collisions_;
  CarRegistry registry_;
  Encounters encounters_;
  std::vector<LidarScene> scenes_;
  MovingPoses moving_poses_;
  bool moving_poses_are_current_{false};
};
}  // namespace f1tenth_sim2d
