#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/trajectory_hash.h"

namespace f1tenth_sim2d
{
/// A Simulation as Python sees it: seconds, numpy arrays, checked indices.
class PythonSimulation
{
public:
  PythonSimulation(const WorldDescription & world, double physics_step, std::uint64_t seed);

  CarId addCar(
    const CarDescription & car, const std::optional<VehicleParameters> & parameters, double x, double y, double yaw);
  std::vector<CarId> cars() const { return simulation_.cars(); }
  void placeCar(CarId car, double x, double y, double yaw);
  const CarDescription & car(CarId car) const;

  double time() const;
  void step();
  void advanceTo(double end);
  void reset();
  std::string trajectoryHash() const { return hash_.hexDigest(); }

  void command(CarId car, double speed, double steering_angle);
  void commandTwist(CarId car, double linear_x, double angular_z, double linear_y);

  CarState state(CarId car) const;
  WheelOdometry wheelOdometry(CarId car) const;
  ImuSample imu(CarId car) const;
  std::vector<Contact> contacts(CarId car) const;
  void clearContacts(CarId car);
  double clearance(CarId car, double limit) const;
  pybind11::array_t<double> poses() const;
  /// Into out, a float32 array of shape (beam_count,), or into a new one.
  pybind11::array scan(CarId car, std::size_t lidar, const pybind11::object & out, bool exact) const;

  std::vector<std::string> modelNames() const { return simulation_.modelNames(); }
  pybind11::tuple modelPose(const std::string & name) const;

private:
  Simulation simulation_;
  TrajectoryHash hash_;
};
}  // namespace f1tenth_sim2d
