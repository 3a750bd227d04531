#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/trajectory_log.h"
#include "environment/observation.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What all episodes of an environment have in common.
struct EnvironmentOptions
{
  std::vector<CarDescription> cars;
  std::optional<Course> course;
  std::vector<std::string> parts;  ///< of an observation, by name
  bool rates{false};               ///< actions are (steering rate, acceleration) instead of (steering angle, speed)
  double period{0.025};            ///< s, of an action
  double physics_step{0.001};      ///< s
};

/// How a car begins an episode.
struct CarStart
{
  VehicleParameters parameters;
  Pose2 pose;
  double speed{0.0};        ///< m/s
  double lidar_noise{0.0};  ///< m, standard deviation of each range
};

/// Steering angle, rad, and speed, m/s; or steering rate, rad/s, and acceleration, m/s^2.
using Action = std::array<double, 2>;

/// Turns rates that a driver asks for into the targets that a car follows.
class Pedals
{
public:
  Pedals(const VehicleParameters & parameters, double speed);

  /// The command of the next physics step.
  /// @param steering_rate  rad/s
  /// @param acceleration   m/s^2
  /// @param dt             s
  DriveCommand press(const CarState & state, double steering_rate, double acceleration, double dt);

private:
  VehicleParameters parameters_;
  double speed_;                ///< m/s, that the driver has asked for so far
  double steering_angle_{0.0};  ///< rad, likewise
};

/// An episode at some moment, to go on from; before the first reset there is no simulation.
struct Episode
{
  std::optional<Simulation::Snapshot> simulation;
  std::vector<CarId> ids;
  std::vector<Pedals> pedals;
  std::vector<CarResult> results;
  std::int64_t steps;
};

/// One simulation that is driven by actions, period by period, and answers with observations.
class Environment
{
public:
  /// @param options, observation  outlive this
  Environment(const PreparedWorld & world, const EnvironmentOptions & options, const Observation & observation)
  : world_(world), options_(options), observation_(observation)
  {
  }

  /// Begins an episode: time 0, the cars where they start.
  /// @throws Error if a car's place is not free or its parameters are not allowed; everything is then as before
  void reset(std::uint64_t seed, const std::vector<CarStart> & starts);

  /// Drives for one period.
  /// @param actions  one per car
  /// @param driven   one per car: a car that nobody drives stops
  void step(const Action * actions, const std::uint8_t * driven);

  /// Writes what the cars do from now on, until the episode ends, as the node's parameter `record` does.
  /// @param file  empty: nothing more
  /// @throws Error before the first reset, or if the file cannot be written
  void record(const std::string & file);

  /// An episode as it stands. @throws Error while it is recorded, or as Simulation::snapshot
  Episode snapshot() const;
  /// @throws Error for another number of cars, or while an episode is recorded
  void restore(const Episode & episode);

  const std::vector<CarResult> & cars() const { return results_; }
  double time() const { return simulation_ ? toSeconds(simulation_->time()) : 0.0; }  ///< s
  /// Rows of all cars, one after the other.
  void observe(float * rows) const;
  /// What the first eye of the first camera of a car sees. @throws Error before the first reset, or without a camera
  void look(std::size_t car, Picture & picture) const;

private:
  void command(const Action * actions, const std::uint8_t * driven);
  void look();
  void log();
  void measure(CarResult & car, const CarState & state) const;
  void refuseRecording() const;

  PreparedWorld world_;
  const EnvironmentOptions & options_;
  const Observation & observation_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<CarId> ids_;
  std::vector<Pedals> pedals_;
  std::vector<CarResult> results_;
  std::unique_ptr<TrajectoryLog> log_;
  std::int64_t steps_{0};
};
}  // namespace f1tenth_sim2d
