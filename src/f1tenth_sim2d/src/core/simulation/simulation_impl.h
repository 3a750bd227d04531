#pragma once

#include <array>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/contacts/collision_world.h"
#include "core/lidar/lidar_scene.h"
#include "core/simulation/car_registry.h"
#include "core/simulation/world_geometry.h"
#include "core/view/view.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What a simulation consists of, and what its functions have in common.
struct Simulation::Impl : MovingPoses
{
  using Scenes = std::deque<LidarScene>;

  Impl(std::shared_ptr<const WorldGeometry> world, const SimulationOptions & wanted);
  Impl(const Impl & other);

  RegisteredCar & car(CarId id) const { return registry.at(id); }
  const Cars & cars() const { return registry.cars(); }
  const WorldDescription & world() const { return geometry->world(); }
  Pose2 ofModel(std::size_t model) const override;
  Pose2 ofCar(CarId car) const override;

  /// What is seen at a height, m; made at the first call.
  const LidarScene & sceneAt(double height) const;
  void scan(CarId id, std::size_t lidar, bool noisy, float * ranges) const;
  std::uint64_t keyOfNoise(CarId id, const std::string & sensor) const;
  void letIn(std::unique_ptr<RegisteredCar> car);
  void forgetScenes() noexcept { scenes.clear(); }
  void refuseOccupiedPlace(const std::vector<PlacedCar> & places, std::size_t own, const std::string & what) const;
  void refuseTakenName(const std::string & name) const;
  void logContacts();
  void changeWorld(WorldDescription world, const std::vector<ModelMotion> & motions);
  /// Without cars, but with room for all of them.
  std::unique_ptr<CollisionWorld> emptyCollisions() const;
  void enter(std::unique_ptr<CollisionWorld> entered) noexcept;
  void returnModels();
  /// Begins the rigid-body world anew, with all bodies as in another one; not one as built, which stays so.
  void renewCollisions(const CollisionWorld & other);

  std::shared_ptr<const WorldGeometry> geometry;
  SimulationOptions options;
  SimTime step_length;
  double dt;  ///< s
  SimTime time{0};
  std::vector<Pose3> start_poses;  ///< of the models; they may have been put elsewhere
  bool models_moved{false};
  std::unique_ptr<CollisionWorld> collisions;
  CarRegistry registry;
  /// For const functions that draw, on two threads at once.
  struct Viewer
  {
    std::mutex mutex;
    View view;
  };
  std::array<Viewer, 2> viewers;

private:
  std::string nameOf(const Piece & piece) const;
  void describe(const RegisteredCar & car, const StepContact & step, Contact & contact) const;

  mutable std::mutex scenes_mutex;  ///< for const functions that add one
  mutable Scenes scenes;            ///< of the cars and the geometry that are there now
};
}  // namespace f1tenth_sim2d
