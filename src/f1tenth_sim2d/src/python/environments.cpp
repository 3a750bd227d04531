#include "environment/environments.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <string>

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/python_world.h"
#include "python/turn.h"

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style>;
using Flags = py::array_t<bool, py::array::c_style>;

/// Environments that one thread at a time may use.
class PythonEnvironments : public Environments
{
public:
  using Environments::Environments;
  std::atomic_flag & taken() { return taken_; }

private:
  std::atomic_flag taken_ = ATOMIC_FLAG_INIT;
};

std::vector<Vec2> pointsOf(const Doubles & points)
{
  if (points.ndim() != 2 || points.shape(1) != 2) {
    throw py::value_error("points: allowed is an array of shape (n, 2)");
  }
  std::vector<Vec2> result;
  for (py::ssize_t i = 0; i < points.shape(0); ++i) {
    result.push_back({points.at(i, 0), points.at(i, 1)});
  }
  return result;
}

void bindCourse(py::module_ & module)
{
  py::class_<Course>(module, "Course", "A closed line that is driven in the order of its points.")
    .def(
      py::init([](const Doubles & points) { return Course(pointsOf(points)); }), py::arg("points"),
      R"(Args:
    points: array of shape (n, 2), in the world, m; the last one is joined to the first.

Raises:
    Error: fewer than three points, one that is not finite or the same as the next.
)")
    .def(
      "__deepcopy__", [](const py::object & course, const py::dict &) { return course; }, py::arg("memo"))
    .def_property_readonly("length", &Course::length, "m.")
    .def(
      "pose",
      [](const Course & course, double distance, double offset) {
        const Pose2 pose = course.pose(distance, offset);
        return py::make_tuple(pose.x, pose.y, pose.yaw);
      },
      py::arg("distance"), py::arg("offset") = 0.0,
      "(x, y, yaw), m and rad, so far along the course and so much to its left, m.")
    .def(
      "locate",
      [](const Course & course, double x, double y, double yaw) {
        const CoursePosition position = course.locate({x, y, yaw});
        return py::make_tuple(position.distance, position.offset, position.heading);
      },
      py::arg("x"), py::arg("y"), py::arg("yaw") = 0.0,
      "(distance along the course, offset to its left, heading from it) of a pose, m and rad.");
}

PythonEnvironments * makeEnvironments(
  PythonWorld & world, std::vector<CarDescription> cars, std::optional<Course> course,
  const std::vector<std::string> & observation, const std::string & actions, double period, double physics_step,
  std::size_t count, std::size_t threads)
{
  if (actions != "speed" && actions != "acceleration") {
    throw py::value_error("actions: found '" + actions + "', allowed are speed, acceleration");
  }
  EnvironmentOptions options{std::move(cars), std::move(course), observation, actions == "acceleration",
                             period,          physics_step};
  return new PythonEnvironments(world.prepared(), std::move(options), count, threads);
}

void reset(
  PythonEnvironments & environments, std::size_t index, std::uint64_t seed,
  const std::vector<VehicleParameters> & parameters, const Doubles & starts, const std::vector<double> & lidar_noise)
{
  const auto cars = static_cast<py::ssize_t>(environments.cars());
  const bool fits = starts.ndim() == 2 && starts.shape(0) == cars && starts.shape(1) == 4;
  if (!fits || parameters.size() != environments.cars() || lidar_noise.size() != environments.cars()) {
    throw py::value_error("allowed are one VehicleParameters, start (x, y, yaw, speed) and lidar noise per car");
  }
  std::vector<CarStart> all;
  for (py::ssize_t i = 0; i < cars; ++i) {
    const auto car = static_cast<std::size_t>(i);
    all.push_back(
      {parameters[car], {starts.at(i, 0), starts.at(i, 1), starts.at(i, 2)}, starts.at(i, 3), lidar_noise[car]});
  }
  const Turn turn(environments.taken());
  environments.reset(index, seed, all);
}

void record(PythonEnvironments & environments, std::size_t index, const std::string & file)
{
  const Turn turn(environments.taken());
  environments.record(index, file);
}

py::tuple look(PythonEnvironments & environments, std::size_t index, std::size_t car)
{
  const Turn turn(environments.taken());
  Picture picture;
  environments.look(index, car, picture);
  return toArrays(std::move(picture));
}

Episode snapshot(PythonEnvironments & environments, std::size_t index)
{
  const Turn turn(environments.taken());
  return environments.snapshot(index);
}

void restore(PythonEnvironments & environments, std::size_t index, const Episode & episode)
{
  const Turn turn(environments.taken());
  environments.restore(index, episode);
}

void step(PythonEnvironments & environments, const Doubles & actions, const Flags & driven)
{
  const auto cars = static_cast<py::ssize_t>(environments.count() * environments.cars());
  if (actions.size() != 2 * cars || driven.size() != cars) {
    throw py::value_error("allowed are actions of shape (environments, cars, 2), driven of shape (environments, cars)");
  }
  static_assert(sizeof(Action) == 2 * sizeof(double) && sizeof(bool) == sizeof(std::uint8_t));
  const auto * const first_action = reinterpret_cast<const Action *>(actions.data());
  const auto * const first_driven = reinterpret_cast<const std::uint8_t *>(driven.data());
  const Turn turn(environments.taken());
  const py::gil_scoped_release release;
  environments.step(first_action, first_driven);
}

/// Memory of the environments as an array that keeps them alive.
py::array view(
  const py::object & self, const py::dtype & type, const void * numbers, const std::vector<std::size_t> & shape)
{
  return {type, shape, numbers, self};
}

void bindArrays(py::class_<PythonEnvironments> & type)
{
  type
    .def_property_readonly(
      "observations",
      [](const py::object & self) {
        auto & all = self.cast<PythonEnvironments &>();
        return view(
          self, py::dtype::of<float>(), all.observations().data(), {all.count(), all.cars(), all.observation().size()});
      },
      "What the cars observe: float32 array of shape (count, cars, size), a view.")
    .def_property_readonly(
      "results",
      [](const py::object & self) {
        auto & all = self.cast<PythonEnvironments &>();
        return view(self, py::dtype::of<CarResult>(), all.results().data(), {all.count(), all.cars()});
      },
      R"(What has become of the cars: structured array of shape (count, cars), a view. Fields, float64: x, y, yaw, v_x, v_y,
yaw_rate, steering_angle, as CarState; course_distance, course_offset, course_heading, as Course.locate; progress in the
last step and distance since the start along the course, or the car's own path if there is none, m; laps since the
start; contact, 1 if the car touched something in the last step.)")
    .def_property_readonly(
      "times",
      [](const py::object & self) {
        auto & all = self.cast<PythonEnvironments &>();
        return view(self, py::dtype::of<double>(), all.times().data(), {all.count()});
      },
      "Simulated time of each environment, s: float64 array of shape (count,), a view.")
    .def_property_readonly(
      "part_sizes", [](const PythonEnvironments & all) { return all.observation().sizes(); },
      "How many numbers each part of the observation has.")
    .def_property_readonly(
      "bounds", [](const PythonEnvironments & all) { return all.observation().bounds(); },
      "(least, greatest) of each number of an observation.");
}
}  // namespace

void bindEnvironments(py::module_ & module)
{
  bindCourse(module);
  PYBIND11_NUMPY_DTYPE(
    CarResult, x, y, yaw, v_x, v_y, yaw_rate, steering_angle, course_distance, course_offset, course_heading, progress,
    distance, laps, contact);
  py::class_<Episode>(module, "Episode", "An episode of an environment at some moment; never changes.");
  py::class_<PythonEnvironments> type(
    module, "Environments",
    R"(Simulations of one world, stepped together by several threads, for what learns from many at once.

The world is shared. Each simulation is as if it were alone, bit for bit, whatever their number and that of the threads.
One thread at a time may call them: a call while another thread is in one raises RuntimeError.)");
  type.def(
    py::init(&makeEnvironments), py::arg("world"), py::arg("cars"), py::arg("course"), py::arg("observation"),
    py::arg("actions") = "speed", py::arg("period") = 0.025, py::arg("physics_step") = 0.001, py::arg("count") = 1,
    py::arg("threads") = 1,
    R"(Args:
    world: from load_world.
    cars: list of Car, for each environment.
    course: a Course, or None.
    observation: names of the parts of an observation, in order: scan, pose, velocity, steering, course, laps, contact,
        others, and names of the components of the cars.
    actions: speed: (steering angle, rad, speed, m/s); acceleration: (steering rate, rad/s, acceleration, m/s^2).
    period: of an action, s.
    physics_step: s.
    count: number of environments.
    threads: number of threads that step them.

Raises:
    Error: an unknown part, or nothing to simulate.
)");
  type
    .def(
      "reset", &reset, py::arg("index"), py::arg("seed"), py::arg("parameters"), py::arg("starts"),
      py::arg("lidar_noise"),
      R"(Begin an episode of one environment.

Args:
    index: of the environment.
    seed: of its noise.
    parameters: VehicleParameters of each car.
    starts: array of shape (cars, 4): x, y, yaw, m and rad, and speed, m/s.
    lidar_noise: standard deviation of the ranges of each car, m.

Raises:
    Error: a place that is not free, or parameters that are not allowed; the environment is then as before.
)")
    .def(
      "step", &step, py::arg("actions"), py::arg("driven"),
      R"(Drive all environments for one period; other threads of Python run meanwhile.

Args:
    actions: float64 array of shape (count, cars, 2).
    driven: bool array of shape (count, cars): a car that nobody drives stops, and an environment in which nobody drives
        stands still in time.
)");
  type
    .def(
      "look", &look, py::arg("index"), py::arg("car"),
      R"(What the first eye of the first camera of a car sees now; see Simulation.look.

Args:
    index: of the environment.
    car: index of the car.

Raises:
    Error: the environment has not been reset yet, or the car has no camera.
)")
    .def(
      "snapshot", &snapshot, py::arg("index"),
      R"(The episode of one environment as it is now, for restore; see Simulation.snapshot.

Raises:
    Error: it is recorded, or a component of a car cannot be copied.
)")
    .def(
      "restore", &restore, py::arg("index"), py::arg("episode"),
      R"(Go on with an episode in one environment.

Args:
    index: of the environment.
    episode: from snapshot, of an environment of the same settings; it serves any number of times.

Raises:
    Error: an episode of another number of cars, or what goes on there is recorded.
)");
  type.def(
    "record", &record, py::arg("index"), py::arg("file"),
    R"(Write what the cars of one environment do from now on into a file, as the node's parameter `record` does: a row per car and
period, until its episode ends.

Args:
    index: of the environment.
    file: path of the CSV file; empty: stop writing.

Raises:
    Error: before the first reset, or if the file cannot be written.
)");
  bindArrays(type);
}
}  // namespace f1tenth_sim2d
