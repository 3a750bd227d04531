#include <pybind11/stl.h>

#include "f1tenth_sim2d/simulation.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;

/// Reads part of a member.
template <typename Owner, typename Member>
auto through(Member Owner::*member, double Member::*part)
{
  return [member, part](const Owner & owner) { return owner.*member.*part; };
}

void bindCarState(py::module_ & module)
{
  py::class_<CarState>(module, "CarState", "True state of a car: that of base_footprint, below the rear axle.")
    .def("__repr__", &shown)
    .def_property_readonly("x", through(&CarState::pose, &Pose2::x), "In the world, m.")
    .def_property_readonly("y", through(&CarState::pose, &Pose2::y), "In the world, m.")
    .def_property_readonly("yaw", through(&CarState::pose, &Pose2::yaw), "In the world, rad.")
    .def_property_readonly("v_x", through(&CarState::velocity, &Vec2::x), "Along the car, m/s.")
    .def_property_readonly("v_y", through(&CarState::velocity, &Vec2::y), "To its left, m/s.")
    .def_readonly("yaw_rate", &CarState::yaw_rate, "rad/s.")
    .def_property_readonly(
      "a_x", through(&CarState::acceleration, &Vec2::x), "Of the centre of mass, along the car, m/s^2.")
    .def_property_readonly(
      "a_y", through(&CarState::acceleration, &Vec2::y), "Of the centre of mass, to its left, m/s^2.")
    .def_readonly("steering_angle", &CarState::steering_angle, "Of the single-track front wheel, rad.")
    .def_readonly("wheel_angles", &CarState::wheel_angles, "Front left, front right, rear left, rear right; rad.")
    .def_readonly("wheel_speeds", &CarState::wheel_speeds, "The same order; rad/s.");
}

void bindOdometry(py::module_ & module)
{
  py::class_<WheelOdometry>(module, "WheelOdometry", "Dead reckoning from noisy speed and steering.")
    .def("__repr__", &shown)
    .def_property_readonly("x", through(&WheelOdometry::pose, &Pose2::x), "m.")
    .def_property_readonly("y", through(&WheelOdometry::pose, &Pose2::y), "m.")
    .def_property_readonly("yaw", through(&WheelOdometry::pose, &Pose2::yaw), "rad.")
    .def_readonly("speed", &WheelOdometry::speed, "Along the car, m/s.")
    .def_readonly("yaw_rate", &WheelOdometry::yaw_rate, "rad/s.");
}

void bindContact(py::module_ & module)
{
  py::class_<Contact>(module, "Contact", "A touch of a car's collision element with another body.")
    .def("__repr__", &shown)
    .def_readonly("own_collision", &Contact::own_collision, "Scoped name.")
    .def_readonly("other_collision", &Contact::other_collision, "Scoped name.")
    .def_readonly("other_model", &Contact::other_model, "Name of the model or car.")
    .def_property_readonly(
      "positions", [](const Contact & contact) { return toArray(contact.positions); }, "Shape (n, 2), world, m.")
    .def_property_readonly(
      "normals", [](const Contact & contact) { return toArray(contact.normals); },
      "Shape (n, 2), unit vectors in the world, from the other body towards the car.")
    .def_readonly("depths", &Contact::depths, "m.")
    .def_property_readonly(
      "force", [](const Contact & contact) { return py::make_tuple(contact.force.x, contact.force.y); },
      "(x, y) on the car, world, N.")
    .def_readonly("torque", &Contact::torque, "About the car's centre of mass, N m.")
    .def_readonly(
      "speed", &Contact::speed,
      "Of the touching points against each other before the impact, m/s, whichever moved: the greatest.");
}
}  // namespace

void bindSamples(py::module_ & module)
{
  bindCarState(module);
  bindOdometry(module);
  bindContact(module);
}
}  // namespace f1tenth_sim2d
