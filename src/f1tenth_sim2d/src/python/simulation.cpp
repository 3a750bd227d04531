#include <pybind11/stl.h>

#include <cstdint>
#include <memory>

#include "python/bindings.h"
#include "python/python_simulation.h"
#include "python/turn.h"

namespace pybind11::detail
{
/// In Python a CarId is an int.
template <>
struct type_caster<f1tenth_sim2d::CarId>
{
  PYBIND11_TYPE_CASTER(f1tenth_sim2d::CarId, const_name("int"));

  bool load(handle source, bool convert)
  {
    make_caster<std::uint32_t> number;
    if (!number.load(source, convert)) {
      return false;
    }
    value = f1tenth_sim2d::CarId{cast_op<std::uint32_t>(number)};
    return true;
  }

  static handle cast(f1tenth_sim2d::CarId id, return_value_policy policy, handle parent)
  {
    return make_caster<std::uint32_t>::cast(static_cast<std::uint32_t>(id), policy, parent);
  }
};
}  // namespace pybind11::detail

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;
using S = PythonSimulation;
using Class = py::class_<S>;
using ReleaseGil = py::call_guard<py::gil_scoped_release>;

void bindTime(Class & type)
{
  type.def_property_readonly("time", inTurn<S>(&S::time), "Simulated time since the start, s.")
    .def("step", inTurn<S>(&S::step), "Advance by one physics step.", ReleaseGil())
    .def(
      "advance_to", inTurn<S>(&S::advanceTo), py::arg("time"),
      "Step until the simulated time is at least `time`, s. Ctrl-C ends it earlier.", ReleaseGil())
    .def(
      "snapshot", inTurn<S>(&S::snapshot),
      R"(This moment, for restore: with all cars, their commands and components, models, time, noise and hash.

What is restored does from then on what this simulation does, bit for bit, for the same calls. For that, contacts that last
are solved from here on as if they had just begun, here as there; a drive in which nothing touches is not changed by it.

Raises:
    Error: a component of a car cannot be copied.
)")
    .def(
      "restore", inTurn<S>(&S::restore), py::arg("snapshot"),
      "Go back to a moment of this simulation, or on from one of another. A snapshot serves any number of times.")
    .def(
      "__deepcopy__",
      [](S & simulation, const py::dict &) {
        const Turn turn(simulation.taken());
        return std::make_unique<S>(simulation.snapshot());
      },
      py::arg("memo"))
    .def("reset", inTurn<S>(&S::reset), "Back to time 0, with all cars at their start and the same seed.")
    .def(
      "trajectory_hash", inTurn<S>(&S::trajectoryHash),
      R"(SHA-256 over all car states at the end of each control period since the start, 64 hexadecimal digits.

It does not matter by which calls time was advanced. The ROS node has the same hash for the same drive.)");
}

void bindCars(Class & type)
{
  type
    .def(
      "add_car", inTurn<S>(&S::addCar), py::arg("car"), py::arg("parameters") = py::none(), py::arg("x") = 0.0,
      py::arg("y") = 0.0, py::arg("yaw") = 0.0,
      R"(Put a car into the world.

Args:
    car: its description, from load_car.
    parameters: VehicleParameters; default: those that the description gives, as in the ROS node.
    x, y, yaw: pose of base_footprint in the world, m and rad.

Returns:
    Id of the car. Ids count from 0 and are never given to another car.

Raises:
    Error: the name is taken, or the place is not free; nothing has changed then.
)")
    .def(
      "remove_car", inTurn<S>(&S::removeCar), py::arg("car"),
      "Take a car out. The others keep their ids and their noise. Raises IndexError if it is not there.")
    .def(
      "place_car", inTurn<S>(&S::placeCar), py::arg("car"), py::arg("x"), py::arg("y"), py::arg("yaw"),
      py::arg("v_x") = 0.0, py::arg("v_y") = 0.0, py::arg("yaw_rate") = 0.0,
      R"(Put a car somewhere else, as a hand would: its commands stay in force, wheel odometry does not notice.

Args:
    car: its id.
    x, y, yaw: pose of base_footprint in the world, m and rad.
    v_x, v_y: velocity of base_footprint along the car and to its left, m/s.
    yaw_rate: rad/s.

Raises:
    Error: the place is not free, or a number is not finite; the car then stays where it is.
)")
    .def_property_readonly(
      "cars", inTurn<S>(&S::cars), "Ids of the cars that are there, in the order in which they came.")
    .def("car", inTurn<S>(&S::car), py::arg("car"), "Description of a car, a copy.")
    .def("parameters", inTurn<S>(&S::parameters), py::arg("car"), "VehicleParameters of a car, a copy.")
    .def(
      "command", inTurn<S>(&S::command), py::arg("car"), py::arg("speed"), py::arg("steering_angle"),
      "Ask for a speed, m/s, and a steering angle, rad. Raises Error for a value that is not finite.")
    .def(
      "command_twist", inTurn<S>(&S::commandTwist), py::arg("car"), py::arg("linear_x"), py::arg("angular_z"),
      py::arg("linear_y") = 0.0,
      "Ask for a speed, m/s, and a yaw rate, rad/s, as cmd_vel does; linear_y, m/s to the left, is for planar drives.");
}

void bindReadings(Class & type)
{
  type.def("state", inTurn<S>(&S::state), py::arg("car"), "True state of a car: a CarState, a copy.")
    .def(
      "poses", inTurn<S>(&S::poses),
      "Poses of all cars in the world: float64 array of shape (len(cars), 3), x, y, yaw.")
    .def("wheel_odometry", inTurn<S>(&S::wheelOdometry), py::arg("car"), "A WheelOdometry, from the start pose.")
    .def(
      "sample", inTurn<S>(&S::sample), py::arg("car"), py::arg("component"),
      R"(What a component of a car measures now.

Args:
    car: its id.
    component: its name, one of Car.components.

Returns:
    dict of float64 arrays of shape (n,), by channel; all are views of one array.

Raises:
    ValueError: the car has no such component, with the names of those that it has.
)")
    .def(
      "look", inTurn<S>(&S::look), py::arg("car"), py::arg("camera"), py::arg("eye") = "",
      R"(What a camera of a car sees now. The first look reads the files of all that can be seen.

Args:
    car: its id.
    camera: its name, one of Car.cameras.
    eye: name of one of its eyes; default: the first.

Returns:
    (colour, depth): uint8 array of shape (height, width, 3), red, green and blue, with the camera's noise; float32 array
    of shape (height, width), m along the axis of the camera, +inf where nothing is.

Raises:
    ValueError: the car has no such camera, with the names of those that it has.
    Error: the camera has no such eye.
)")
    .def_property_readonly(
      "view_warning", inTurn<S>(&S::viewWarning),
      "What cameras do not see as it is described: the first such thing, and how many more; empty: nothing.")
    .def(
      "contacts", inTurn<S>(&S::contacts), py::arg("car"), "Contacts since the last clear_contacts, ground excluded.")
    .def("clear_contacts", inTurn<S>(&S::clearContacts), py::arg("car"))
    .def(
      "clearance", inTurn<S>(&S::clearance), py::arg("car"), py::arg("limit") = 5.0,
      R"(Least distance from the car's outline to anything it could touch, m; 0 in contact.

Args:
    car: its id.
    limit: m, the most that is returned; the less, the faster.

Raises:
    Error: limit is negative or not a number; it may be infinite.
)")
    .def(
      "scan", inTurn<S>(&S::scan), py::arg("car"), py::arg("lidar") = 0, py::arg("out") = py::none(),
      py::arg("exact") = false,
      R"(What a lidar of a car measures now.

Args:
    car: its id.
    lidar: which one of the car, counted from 0.
    out: float32 array of shape (beam_count,) to write into without a copy; default: a new one.
    exact: leave the noise out.

Returns:
    Ranges, m, from angle_min to angle_max; +inf where nothing is hit within range_max, -inf nearer than range_min.

Raises:
    ValueError: out has another dtype or shape, is not contiguous or not writeable.
    IndexError: no such car or lidar.
)")
    .def(
      "scans", inTurn<S>(&S::scans), py::arg("lidar") = 0, py::arg("out") = py::none(), py::arg("exact") = false,
      R"(What a lidar of each car measures now, in the order of `cars`.

Args:
    lidar: which one of each car, counted from 0.
    out: float32 array of shape (len(cars), beam_count) to write into without a copy; default: a new one.
    exact: without noise.

Returns:
    out.

Raises:
    ValueError: as scan, or the lidars differ in their number of beams.
    IndexError: a car has no such lidar.
)")
    .def(
      "cast_rays", inTurn<S>(&S::castRays), py::arg("car"), py::arg("directions"), py::arg("x") = 0.0,
      py::arg("y") = 0.0, py::arg("height") = 0.1, py::arg("yaw") = 0.0, py::arg("range_max") = 100.0,
      R"(What level rays from a point of a car meet now, without noise. The car does not see itself.

Args:
    car: its id.
    directions: array of shape (n,), rad, from the heading of the point.
    x, y, yaw: the point in the frame of the car, m and rad.
    height: above the ground, m.
    range_max: m.

Returns:
    float64 array of shape (n,): ranges, m, +inf where nothing is within range_max.

Raises:
    Error: a number is not finite, or range_max is not 0 or more; it may be infinite.
)");
}

void bindModels(Class & type)
{
  type.def("model_names", inTurn<S>(&S::modelNames), "Names of the world's models.")
    .def(
      "model_pose", inTurn<S>(&S::modelPose), py::arg("name"),
      "(x, y, yaw) of a model now. Raises Error for an unknown name.")
    .def(
      "add_model", inTurn<S>(&S::addModel), py::arg("model"),
      R"(Put one more model into the world; reset brings it back to this pose. Costs as much as loading the world.

Args:
    model: a Model, from load_model or of another world.

Raises:
    Error: the name is taken, or a movable model has no mass.
)")
    .def(
      "remove_model", inTurn<S>(&S::removeModel), py::arg("name"),
      "Take a model out. Raises Error for an unknown name.")
    .def(
      "place_model", inTurn<S>(&S::placeModel), py::arg("name"), py::arg("x"), py::arg("y"), py::arg("yaw"),
      py::arg("v_x") = 0.0, py::arg("v_y") = 0.0, py::arg("yaw_rate") = 0.0,
      R"(Put a model somewhere else; its height and tilt stay.

Args:
    name: of the model.
    x, y, yaw: pose of its frame in the world, m and rad.
    v_x, v_y: its velocity in the world, m/s; a static model has none.
    yaw_rate: rad/s.

Raises:
    Error: an unknown name, or a number that is not finite.
)");
}
}  // namespace

void bindSimulation(py::module_ & module)
{
  py::class_<S::Snapshot>(module, "Snapshot", "A moment of a Simulation; never changes.");
  Class type(
    module, "Simulation",
    R"(A world with cars in it, advanced in fixed steps. The same calls with the same seed give the same states, bit for
bit.

One thread at a time may use it: a call while another thread is in one raises RuntimeError. step, advance_to, scan and scans let
other threads of Python run, so that simulations of different threads run side by side.)");
  type.def(
    py::init<PythonWorld &, double, std::uint64_t, double>(), py::arg("world"), py::arg("physics_step") = 0.001,
    py::arg("seed") = 0, py::arg("control_period") = 0.025,
    R"(Args:
    world: from load_world; all simulations of it share its walls.
    physics_step: s.
    seed: of all noise.
    control_period: s, of the trajectory hash.
)");
  bindTime(type);
  bindCars(type);
  bindReadings(type);
  bindModels(type);
}
}  // namespace f1tenth_sim2d
