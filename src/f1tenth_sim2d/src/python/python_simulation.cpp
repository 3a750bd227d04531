#include "python/python_simulation.h"

#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;

/// Indices that users give are answered with IndexError.
void requireIndex(const char * what, std::size_t index, std::size_t count)
{
  if (index >= count) {
    const std::string allowed = count == 0 ? "there is none" : "allowed are 0 to " + std::to_string(count - 1);
    throw py::index_error(std::string(what) + " is " + std::to_string(index) + ", " + allowed);
  }
}

[[noreturn]] void refuseScanArray(const std::string & found, py::ssize_t beam_count)
{
  throw py::value_error(
    "out " + found + ", allowed is a writeable, contiguous numpy array of dtype float32 and shape (" +
    std::to_string(beam_count) + ",)");
}

/// A scan is written into the caller's memory, so the array has to be just that memory.
py::array requireScanArray(const py::object & out, py::ssize_t beam_count)
{
  if (!py::isinstance<py::array>(out)) {
    refuseScanArray("is no numpy array", beam_count);
  }
  const auto array = py::reinterpret_borrow<py::array>(out);
  const bool fits = py::isinstance<py::array_t<float>>(array) && array.ndim() == 1 && array.shape(0) == beam_count &&
                    (array.flags() & py::array::c_style) != 0 && array.writeable();
  if (!fits) {
    const auto dtype = py::str(array.dtype()).cast<std::string>();
    const auto shape = py::str(array.attr("shape")).cast<std::string>();
    refuseScanArray("has dtype " + dtype + " and shape " + shape, beam_count);
  }
  return array;
}
}  // namespace

PythonSimulation::PythonSimulation(const WorldDescription & world, double physics_step, std::uint64_t seed)
: simulation_(world, {physics_step, seed})
{
}

CarId PythonSimulation::addCar(
  const CarDescription & car, const std::optional<VehicleParameters> & parameters, double x, double y, double yaw)
{
  return simulation_.addCar(car, parameters.value_or(VehicleParameters{}), {x, y, yaw});
}

void PythonSimulation::placeCar(CarId car, double x, double y, double yaw)
{
  simulation_.placeCar(car, {x, y, yaw});
}

const CarDescription & PythonSimulation::car(CarId car) const
{
  return simulation_.car(car);
}

double PythonSimulation::time() const
{
  return static_cast<double>(simulation_.time()) * 1e-9;
}

void PythonSimulation::step()
{
  simulation_.step();
}

void PythonSimulation::advanceTo(double end)
{
  if (!std::isfinite(end) || std::abs(end) > 1e9) {
    throw py::value_error("the time to advance to is not finite or beyond 1e9 s");
  }
  simulation_.advanceTo(std::llround(end * 1e9));
  hash_.add(simulation_);
}

void PythonSimulation::reset()
{
  simulation_.reset();
  hash_.reset();
}

void PythonSimulation::command(CarId car, double speed, double steering_angle)
{
  simulation_.command(car, {speed, steering_angle});
}

void PythonSimulation::commandTwist(CarId car, double linear_x, double angular_z, double linear_y)
{
  simulation_.commandTwist(car, linear_x, angular_z, linear_y);
}

CarState PythonSimulation::state(CarId car) const
{
  return simulation_.state(car);
}

WheelOdometry PythonSimulation::wheelOdometry(CarId car) const
{
  return simulation_.wheelOdometry(car);
}

ImuSample PythonSimulation::imu(CarId car) const
{
  return simulation_.imu(car);
}

std::vector<Contact> PythonSimulation::contacts(CarId car) const
{
  return simulation_.contacts(car);
}

void PythonSimulation::clearContacts(CarId car)
{
  simulation_.clearContacts(car);
}

double PythonSimulation::clearance(CarId car, double limit) const
{
  return simulation_.clearance(car, limit);
}

py::array_t<double> PythonSimulation::poses() const
{
  py::array_t<double> array({static_cast<py::ssize_t>(simulation_.cars().size()), py::ssize_t{3}});
  auto cells = array.mutable_unchecked<2>();
  py::ssize_t row = 0;
  for (const CarId car : simulation_.cars()) {
    const Pose2 & pose = simulation_.state(car).pose;
    cells(row, 0) = pose.x;
    cells(row, 1) = pose.y;
    cells(row, 2) = pose.yaw;
    ++row;
  }
  return array;
}

py::array PythonSimulation::scan(CarId car, std::size_t lidar, const py::object & out, bool exact) const
{
  const std::vector<LidarDescription> & lidars = simulation_.car(car).lidars;
  requireIndex("lidar", lidar, lidars.size());
  const py::ssize_t beam_count = lidars[lidar].beam_count;
  py::array array = out.is_none() ? py::array_t<float>(beam_count) : requireScanArray(out, beam_count);
  auto * const ranges = static_cast<float *>(array.mutable_data());
  {
    const py::gil_scoped_release release;
    exact ? simulation_.exactScan(car, lidar, ranges) : simulation_.scan(car, lidar, ranges);
  }
  return array;
}

py::tuple PythonSimulation::modelPose(const std::string & name) const
{
  const Pose2 pose = simulation_.modelPose(name);
  return py::make_tuple(pose.x, pose.y, pose.yaw);
}
}  // namespace f1tenth_sim2d
