#include "f1tenth_sim2d/vehicle_parameters.h"

#include <string>
#include <utility>

#include "python/bindings.h"

namespace f1tenth_sim2d
{
namespace py = pybind11;

void bindVehicleParameters(py::module_ & module)
{
  using T = TireParameters;
  py::class_<T> tire(module, "TireParameters", "Coefficients of Pacejka's magic formula, as CommonRoad names them.");
  tire.def(py::init<>());
  for (const auto & [name, member] :
       {std::pair("p_cx1", &T::p_cx1), {"p_dx1", &T::p_dx1}, {"p_ex1", &T::p_ex1}, {"p_kx1", &T::p_kx1},
        {"p_hx1", &T::p_hx1},          {"p_vx1", &T::p_vx1}, {"r_bx1", &T::r_bx1}, {"r_bx2", &T::r_bx2},
        {"r_cx1", &T::r_cx1},          {"r_ex1", &T::r_ex1}, {"r_hx1", &T::r_hx1}, {"p_cy1", &T::p_cy1},
        {"p_dy1", &T::p_dy1},          {"p_ey1", &T::p_ey1}, {"p_ky1", &T::p_ky1}, {"r_by1", &T::r_by1},
        {"r_by2", &T::r_by2},          {"r_by3", &T::r_by3}, {"r_cy1", &T::r_cy1}, {"r_ey1", &T::r_ey1},
        {"r_hy1", &T::r_hy1},          {"r_vy1", &T::r_vy1}, {"r_vy4", &T::r_vy4}, {"r_vy5", &T::r_vy5},
        {"r_vy6", &T::r_vy6}}) {
    tire.def_readwrite(name, member);
  }

  using P = VehicleParameters;
  py::class_<P>(module, "VehicleParameters", "Numbers of a car's dynamics, actuation and wheel odometry. SI units.")
    .def(py::init<>(), "The F1/10 car of f1tenth_gym.")
    .def_static(
      "load", &loadVehicleParameters, py::arg("path"),
      R"(Read a car's YAML file; a key that is not there keeps its default.

Raises:
    LoadError: unknown key, wrong type or value out of range, with file and line.
)")
    .def_property(
      "model", [](const P & p) { return kVehicleModelNames[static_cast<std::size_t>(p.model)]; },
      [](P & p, const std::string & name) { p.model = vehicleModel(name); },
      "How the car moves: single_track, kinematic or single_track_drift.")
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
    .def_readwrite("R_w", &P::R_w, "Radius of the wheels, m; this and what follows is the drift model's.")
    .def_readwrite("I_y_w", &P::I_y_w, "Inertia of the wheels of an axle about that axle, kg m^2.")
    .def_readwrite("T_sb", &P::T_sb, "Share of the front axle in braking.")
    .def_readwrite("T_se", &P::T_se, "Share of the front axle in driving.")
    .def_readwrite("tire", &P::tire, "TireParameters.")
    .def_readwrite("odometry_rate_hz", &P::odometry_rate_hz, "Hz.")
    .def_readwrite("odometry_speed_scale", &P::odometry_speed_scale, "Measured over true distance.")
    .def_readwrite("odometry_speed_noise_stddev", &P::odometry_speed_noise_stddev, "m/s per sample.")
    .def_readwrite("odometry_steering_offset", &P::odometry_steering_offset, "rad.")
    .def_readwrite("odometry_steering_noise_stddev", &P::odometry_steering_noise_stddev, "rad per sample.")
    .def_property_readonly("wheelbase", &P::wheelbase, "l_f + l_r, m.");
}
}  // namespace f1tenth_sim2d
