#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "python/python_world.h"

namespace f1tenth_sim2d
{
/// A Simulation as Python sees it: seconds, numpy arrays, names, and a trajectory hash at fixed periods.
class PythonSimulation : public Simulation
{
public:
  /// @param control_period  s, of the trajectory hash
  PythonSimulation(PythonWorld & world, double physics_step, std::uint64_t seed, double control_period);

  /// A moment to go back to.
  struct Snapshot
  {
    Simulation::Snapshot simulation;
    TrajectoryHash hash;
    std::int64_t periods;
    double control_period;
  };
  explicit PythonSimulation(const Snapshot & snapshot);
  Snapshot snapshot() { return {Simulation::snapshot(), hash_, periods_, control_period_}; }
  void restore(const Snapshot & snapshot);

  /// For whoever uses this: see Turn.
  std::atomic_flag & taken() { return taken_; }

  CarId addCar(
    const CarDescription & car, const std::optional<VehicleParameters> & parameters, double x, double y, double yaw);
  void placeCar(CarId car, double x, double y, double yaw, double v_x, double v_y, double yaw_rate);

  double time() const { return toSeconds(Simulation::time()); }
  void step();
  /// The caller has released the GIL. @throws pybind11::error_already_set if a signal arrived that raises
  void advanceTo(double end);
  void reset();
  std::string trajectoryHash() const { return hash_.hexDigest(); }

  void command(CarId car, double speed, double steering_angle) { Simulation::command(car, {speed, steering_angle}); }

  pybind11::array_t<double> poses() const;
  /// Into out, a float32 array of shape (beam_count,), or into a new one.
  pybind11::array scan(CarId car, std::size_t lidar, const pybind11::object & out, bool exact) const;
  /// Of all cars, likewise, of shape (cars, beam_count).
  pybind11::array scans(std::size_t lidar, const pybind11::object & out, bool exact) const;
  pybind11::array_t<double> castRays(
    CarId car, const pybind11::array_t<double> & directions, double x, double y, double height, double yaw,
    double range_max) const;

  /// Numbers of a component by channel.
  pybind11::dict sample(CarId car, const std::string & component) const;

  /// Colour and depth that an eye of a camera sees.
  pybind11::tuple look(CarId car, const std::string & camera, const std::string & eye) const;

  pybind11::tuple modelPose(const std::string & name) const;
  void removeModel(const std::string & name) { Simulation::removeModel(indexOfModel(name)); }
  void placeModel(const std::string & name, double x, double y, double yaw, double v_x, double v_y, double yaw_rate);

private:
  SimTime periodEnd() const;
  void hashPeriod();
  pybind11::ssize_t beamCount(CarId car, std::size_t lidar) const;
  void scanInto(float * ranges, CarId car, std::size_t lidar, bool exact) const;

  double control_period_;  ///< s
  TrajectoryHash hash_;
  std::int64_t periods_{0};  ///< in the hash
  std::atomic_flag taken_ = ATOMIC_FLAG_INIT;
};
}  // namespace f1tenth_sim2d
