#include <pybind11/stl.h>

#include "python/bindings.h"
#include "python/car_id_caster.h"
#include "python/python_simulation.h"

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
  type.def_property_readonly("time", &S::time, "Simulated time since the start, s.")
    .def("step", &S::step, "Advance by one physics step.", ReleaseGil())
    .def(
      "advance_to", &S::advanceTo, py::arg("time"),
      "Step until the simulated time is at least `time`, s, and add the states to the trajectory hash.", ReleaseGil())
    .def("reset", &S::reset, "Back to time 0, with all cars at their start and the same seed.")
    .def(
      "trajectory_hash", &S::trajectoryHash,
      "SHA-256 over all car states at the end of each advance_to since the start, 64 hexadecimal digits.");
}

void bindCars(Class & type)
{
  type
    .def(
      "add_car", &S::addCar, py::arg("car"), py::arg("parameters") = py::none(), py::arg("x") = 0.0, py::arg("y") = 0.0,
      py::arg("yaw") = 0.0,
      R"(Put a car into the world.

Args:
    car: its description, from load_car.
    parameters: VehicleParameters; default: the F1/10 car.
    x, y, yaw: pose of base_footprint in the world, m and rad.

Returns:
    Id of the car. Ids count from 0 and are never given to another car.

Raises:
    Error: the name is taken, or the place is not free.
)")
    .def(
      "place_car", &S::placeCar, py::arg("car"), py::arg("x"), py::arg("y"), py::arg("yaw"),
      "Put a car somewhere else, at rest. Raises Error if the place is not free; the car then stays where it is.")
    .def_property_readonly("cars", &S::cars, "Ids of the cars that are there, in the order in which they came.")
    .def("car", &S::car, py::arg("car"), py::return_value_policy::copy, "Description of a car.")
    .def(
      "command", &S::command, py::arg("car"), py::arg("speed"), py::arg("steering_angle"),
      "Ask for a speed, m/s, and a steering angle, rad. Raises Error for a value that is not finite.")
    .def(
      "command_twist", &S::commandTwist, py::arg("car"), py::arg("linear_x"), py::arg("angular_z"),
      py::arg("linear_y") = 0.0,
      "Ask for a speed, m/s, and a yaw rate, rad/s, as cmd_vel does; linear_y, m/s to the left, is for planar drives.");
}

void bindReadings(Class & type)
{
  type.def("state", &S::state, py::arg("car"), "True state of a car: a CarState, a copy.")
    .def("poses", &S::poses, "Poses of all cars in the world: float64 array of shape (len(cars), 3), x, y, yaw.")
    .def("wheel_odometry", &S::wheelOdometry, py::arg("car"), "A WheelOdometry, from the start pose.")
    .def("imu", &S::imu, py::arg("car"), "An ImuSample.")
    .def("contacts", &S::contacts, py::arg("car"), "Contacts since the last clear_contacts, ground excluded.")
    .def("clear_contacts", &S::clearContacts, py::arg("car"))
    .def(
      "clearance", &S::clearance, py::arg("car"), py::arg("limit") = 5.0,
      "Least distance from the car's outline to anything it could touch, m; 0 in contact, at most `limit`.")
    .def(
      "scan", &S::scan, py::arg("car"), py::arg("lidar") = 0, py::arg("out") = py::none(), py::arg("exact") = false,
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
)");
}
}  // namespace

void bindSimulation(py::module_ & module)
{
  Class type(
    module, "Simulation",
    R"(A world with cars in it, advanced in fixed steps. The same calls with the same seed give the same states, bit for
bit. One thread at a time may use it; step, advance_to and scan let other threads of Python run.)");
  type.def(
    py::init<const WorldDescription &, double, std::uint64_t>(), py::arg("world"), py::arg("physics_step") = 0.001,
    py::arg("seed") = 0,
    R"(Args:
    world: from load_world.
    physics_step: s.
    seed: of all noise.
)");
  bindTime(type);
  bindCars(type);
  bindReadings(type);
  type.def("model_names", &S::modelNames, "Names of the world's models.")
    .def("model_pose", &S::modelPose, py::arg("name"), "(x, y, yaw) of a model now. Raises Error for an unknown name.");
}
}  // namespace f1tenth_sim2d
