#include "f1tenth_sim2d/vehicle_parameters.h"

#include "python/bindings.h"

namespace f1tenth_sim2d
{
namespace py = pybind11;

void bindVehicleParameters(py::module_ & module)
{
  using P = VehicleParameters;
  py::class_<P>(module, "VehicleParameters", "Numbers of a car's dynamics, actuation and wheel odometry. SI units.")
    .def(py::init<>(), "The F1/10 car of f1tenth_gym.")
    .def_static(
      "load", &loadVehicleParameters, py::arg("path"),
      R"(Read a car's YAML file; a key that is not there keeps its default.

Raises:
    LoadError: unknown key, wrong type or value out of range, with file and line.
)")
    .def_readwrite("m", &P::m, "Mass, kg.")
    .def_readwrite("l_f", &P::l_f, "Centre of mass to front axle, m.")
    .def_readwrite("l_r", &P::l_r, "Centre of mass to rear axle, m.")
    .def_readwrite("h", &P::h, "Height of the centre of mass, m.")
    .def_readwrite("I_z", &P::I_z, "Yaw inertia, kg m^2.")
    .def_readwrite("mu", &P::mu, "Friction coefficient of tyre on ground.")
    .def_readwrite("C_Sf", &P::C_Sf, "Cornering stiffness coefficient of the front tyres, 1/rad.")
    .def_readwrite("C_Sr", &P::C_Sr, "Cornering stiffness coefficient of the rear tyres, 1/rad.")
    .def_readwrite("steering_max", &P::steering_max, "Greatest steering angle to either side, rad.")
    .def_readwrite("steering_rate_max", &P::steering_rate_max, "rad/s.")
    .def_readwrite("a_max", &P::a_max, "Greatest acceleration and braking, m/s^2.")
    .def_readwrite("v_switch", &P::v_switch, "Speed above which a_max falls with 1/v, m/s.")
    .def_readwrite("v_min", &P::v_min, "Fastest backwards, m/s.")
    .def_readwrite("v_max", &P::v_max, "Fastest forwards, m/s.")
    .def_readwrite("actuation_latency", &P::actuation_latency, "From command to actuator, s.")
    .def_readwrite("speed_gain", &P::speed_gain, "Acceleration asked for per speed error, 1/s.")
    .def_readwrite("command_timeout", &P::command_timeout, "Simulated time without a command before braking, s.")
    .def_readwrite("odometry_rate_hz", &P::odometry_rate_hz, "Hz.")
    .def_readwrite("odometry_speed_scale", &P::odometry_speed_scale, "Measured over true distance.")
    .def_readwrite("odometry_speed_noise_stddev", &P::odometry_speed_noise_stddev, "m/s per sample.")
    .def_readwrite("odometry_steering_offset", &P::odometry_steering_offset, "rad.")
    .def_readwrite("odometry_steering_noise_stddev", &P::odometry_steering_noise_stddev, "rad per sample.")
    .def_property_readonly("wheelbase", &P::wheelbase, "l_f + l_r, m.");
}
}  // namespace f1tenth_sim2d
