#include "python/python_simulation.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "core/components/camera/camera.h"
#include "python/arrays.h"

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;

constexpr double kLongestPeriod = 10.0;  // s
// Steps between two checks for a signal: some 10 ms for a car alone. Each check waits for other threads of Python.
constexpr SimTime kStepsAtOnce = 10'000;

/// A wrong index of a user raises IndexError.
void requireIndex(const char * what, std::size_t index, std::size_t count)
{
  if (index >= count) {
    const std::string allowed = count == 0 ? "there is none" : "allowed are 0 to " + std::to_string(count - 1);
    throw py::index_error(std::string(what) + " is " + std::to_string(index) + ", " + allowed);
  }
}

/// Lets Python handle pending signals, for a caller that has released the GIL.
/// @throws py::error_already_set if that raises, as Ctrl-C does
void checkSignals()
{
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) {
    throw py::error_already_set();
  }
}

/// @throws py::value_error naming those of the kind that there are
template <class Kind>
const Kind & named(
  const char * what, const std::vector<std::shared_ptr<Component>> & components, const std::string & name)
{
  std::string there;
  for (const auto & component : components) {
    const auto * const one = dynamic_cast<const Kind *>(component.get());
    if (one && component->mount().name == name) {
      return *one;
    }
    there += one ? (there.empty() ? "" : ", ") + component->mount().name : "";
  }
  throw py::value_error(
    what + (": found '" + name + "', ") + (there.empty() ? "there is none" : "allowed are " + there));
}

using Shape = std::vector<py::ssize_t>;

[[noreturn]] void refuseScanArray(const std::string & found, const Shape & shape)
{
  throw py::value_error(
    "out " + found + ", allowed is a writeable, contiguous numpy array of dtype float32 and shape " +
    py::str(py::tuple(py::cast(shape))).cast<std::string>());
}

/// Scans are written into the caller's memory, so the array has to be just that memory.
py::array requireScanArray(const py::object & out, const Shape & shape)
{
  if (!py::isinstance<py::array>(out)) {
    refuseScanArray("is no numpy array", shape);
  }
  const auto array = py::reinterpret_borrow<py::array>(out);
  const bool has_shape = Shape(array.shape(), array.shape() + array.ndim()) == shape;
  const bool fits = py::isinstance<py::array_t<float>>(array) && has_shape &&
                    (array.flags() & py::array::c_style) != 0 && array.writeable();
  if (!fits) {
    const auto dtype = py::str(array.dtype()).cast<std::string>();
    const auto found = py::str(array.attr("shape")).cast<std::string>();
    refuseScanArray("has dtype " + dtype + " and shape " + found, shape);
  }
  return array;
}

py::array scanArray(const py::object & out, const Shape & shape)
{
  return out.is_none() ? py::array_t<float>(shape) : requireScanArray(out, shape);
}

py::dict byChannel(const Component & component, const py::array & numbers)
{
  py::dict channels;
  std::size_t begin = 0;
  for (const Channel & channel : component.channels()) {
    channels[py::str(channel.name)] = numbers[py::slice(begin, begin + channel.size, 1)];
    begin += channel.size;
  }
  return channels;
}
}  // namespace

PythonSimulation::PythonSimulation(PythonWorld & world, double physics_step, std::uint64_t seed, double control_period)
: Simulation(world.prepared(), {physics_step, seed}), control_period_(control_period)
{
  if (!(control_period >= physics_step && control_period <= kLongestPeriod)) {
    throw py::value_error(
      "control_period is " + std::to_string(control_period) + " s, allowed is physics_step to 10 s");
  }
}

PythonSimulation::PythonSimulation(const Snapshot & snapshot)
: Simulation(snapshot.simulation),
  control_period_(snapshot.control_period),
  hash_(snapshot.hash),
  periods_(snapshot.periods)
{
}

void PythonSimulation::restore(const Snapshot & snapshot)
{
  Simulation::operator=(Simulation(snapshot.simulation));
  control_period_ = snapshot.control_period;
  hash_ = snapshot.hash;
  periods_ = snapshot.periods;
}

CarId PythonSimulation::addCar(
  const CarDescription & car, const std::optional<VehicleParameters> & parameters, double x, double y, double yaw)
{
  return Simulation::addCar(car, parameters.value_or(car.parameters), {x, y, yaw});
}

void PythonSimulation::placeCar(CarId car, double x, double y, double yaw, double v_x, double v_y, double yaw_rate)
{
  Simulation::placeCar(car, {x, y, yaw}, {v_x, v_y}, yaw_rate);
}

SimTime PythonSimulation::periodEnd() const
{
  return fromSeconds(static_cast<double>(periods_ + 1) * control_period_);
}

void PythonSimulation::hashPeriod()
{
  if (Simulation::time() >= periodEnd()) {
    hash_.add(*this);
    ++periods_;
  }
}

void PythonSimulation::step()
{
  Simulation::step();
  hashPeriod();
}

void PythonSimulation::advanceTo(double end)
{
  if (!std::isfinite(end) || std::abs(end) > 1e9) {
    throw py::value_error("the time to advance to is not finite or beyond 1e9 s");
  }
  const SimTime last = fromSeconds(end);
  SimTime look = Simulation::time() + kStepsAtOnce * stepLength();
  while (Simulation::time() < last) {
    Simulation::advanceTo(std::min({last, periodEnd(), look}));
    hashPeriod();
    if (Simulation::time() >= look) {
      checkSignals();
      look += kStepsAtOnce * stepLength();
    }
  }
}

void PythonSimulation::reset()
{
  Simulation::reset();
  hash_.reset();
  periods_ = 0;
}

py::array_t<double> PythonSimulation::poses() const
{
  std::vector<Pose2> poses;
  for (const CarId car : cars()) {
    poses.push_back(state(car).pose);
  }
  return toArray(poses);
}

py::ssize_t PythonSimulation::beamCount(CarId car, std::size_t lidar) const
{
  const std::vector<LidarDescription> & lidars = Simulation::car(car).lidars;
  requireIndex("lidar", lidar, lidars.size());
  return lidars[lidar].beam_count;
}

void PythonSimulation::scanInto(float * ranges, CarId car, std::size_t lidar, bool exact) const
{
  exact ? exactScan(car, lidar, ranges) : Simulation::scan(car, lidar, ranges);
}

py::array PythonSimulation::scan(CarId car, std::size_t lidar, const py::object & out, bool exact) const
{
  py::array array = scanArray(out, {beamCount(car, lidar)});
  auto * const ranges = static_cast<float *>(array.mutable_data());
  const py::gil_scoped_release release;
  scanInto(ranges, car, lidar, exact);
  return array;
}

py::array PythonSimulation::scans(std::size_t lidar, const py::object & out, bool exact) const
{
  const std::vector<CarId> & cars = Simulation::cars();
  const py::ssize_t beam_count = cars.empty() ? 0 : beamCount(cars[0], lidar);
  for (const CarId car : cars) {
    if (beamCount(car, lidar) != beam_count) {
      throw py::value_error(
        "lidar " + std::to_string(lidar) + " of " + Simulation::car(car).name + " has " +
        std::to_string(beamCount(car, lidar)) + " beams, that of " + Simulation::car(cars[0]).name + " " +
        std::to_string(beam_count) + ": one array needs as many of each");
    }
  }
  py::array array = scanArray(out, {static_cast<py::ssize_t>(cars.size()), beam_count});
  auto * ranges = static_cast<float *>(array.mutable_data());
  const py::gil_scoped_release release;
  for (const CarId car : cars) {
    scanInto(ranges, car, lidar, exact);
    ranges += beam_count;
  }
  return array;
}

py::array_t<double> PythonSimulation::castRays(
  CarId car, const py::array_t<double> & directions, double x, double y, double height, double yaw,
  double range_max) const
{
  if (directions.ndim() != 1) {
    throw py::value_error(
      "directions has " + std::to_string(directions.ndim()) + " dimensions, allowed is 1: shape (n,)");
  }
  RayFan fan{{x, y, yaw}, height, {}, range_max};
  const auto cells = directions.unchecked<1>();
  for (py::ssize_t i = 0; i < cells.shape(0); ++i) {
    fan.directions.push_back(cells(i));
  }
  py::array_t<double> ranges(cells.shape(0));
  Simulation::castRays(car, fan, ranges.mutable_data());
  return ranges;
}

py::dict PythonSimulation::sample(CarId car, const std::string & name) const
{
  const Component & component = named<Component>("component", components(car), name);
  py::array_t<double> numbers(static_cast<py::ssize_t>(sampleSize(component)));
  component.sample(*this, car, numbers.mutable_data());
  return byChannel(component, numbers);
}

py::tuple PythonSimulation::look(CarId car, const std::string & name, const std::string & eye) const
{
  const Camera & camera = named<Camera>("camera", components(car), name);
  Picture picture;
  {
    const py::gil_scoped_release release;
    camera.look(*this, car, {&camera.eye(eye)}, {&picture});
  }
  return toArrays(std::move(picture));
}

py::tuple PythonSimulation::modelPose(const std::string & name) const
{
  const Pose2 pose = Simulation::modelPose(name);
  return py::make_tuple(pose.x, pose.y, pose.yaw);
}

void PythonSimulation::placeModel(
  const std::string & name, double x, double y, double yaw, double v_x, double v_y, double yaw_rate)
{
  Simulation::placeModel(indexOfModel(name), {{x, y, yaw}, {v_x, v_y}, yaw_rate});
}
}  // namespace f1tenth_sim2d
