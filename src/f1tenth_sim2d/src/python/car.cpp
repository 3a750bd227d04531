#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "core/components/camera/camera.h"
#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/section.h"
#include "python/bindings.h"

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;

void bindSensors(py::module_ & module)
{
  py::class_<LidarDescription>(module, "Lidar", "A planar lidar of a car.")
    .def_readonly("name", &LidarDescription::name)
    .def_readonly("topic", &LidarDescription::topic)
    .def_readonly("frame", &LidarDescription::frame, "Frame id without the car's prefix.")
    .def_property_readonly(
      "pose",
      [](const LidarDescription & lidar) {
        const auto & place = lidar.pose.position;
        return py::make_tuple(place.x(), place.y(), place.z(), lidar.pose.yaw());
      },
      "(x, y, z, yaw) in base_footprint, m and rad.")
    .def_readonly("rate_hz", &LidarDescription::rate_hz)
    .def_readonly("beam_count", &LidarDescription::beam_count)
    .def_readonly("angle_min", &LidarDescription::angle_min, "Angle of the first beam, rad.")
    .def_readonly("angle_max", &LidarDescription::angle_max, "Angle of the last beam, rad.")
    .def_readonly("range_min", &LidarDescription::range_min, "m.")
    .def_readonly("range_max", &LidarDescription::range_max, "m.")
    .def_readonly("noise_mean", &LidarDescription::noise_mean, "m.")
    .def_readonly("noise_stddev", &LidarDescription::noise_stddev, "m.");

  py::class_<BumperDescription>(module, "Bumper", "A contact sensor of a car.")
    .def_readonly("name", &BumperDescription::name)
    .def_readonly("topic", &BumperDescription::topic)
    .def_readonly("frame", &BumperDescription::frame, "Frame id without the car's prefix.")
    .def_readonly("rate_hz", &BumperDescription::rate_hz)
    .def_readonly("collision_names", &BumperDescription::collision_names, "Scoped names of what it watches.");
}

void bindCameraEye(py::module_ & module)
{
  using Eye = Camera::Eye;
  const auto of_pinhole = [](auto Pinhole::*part) { return [part](const Eye & eye) { return eye.pinhole.*part; }; };
  py::class_<Eye>(module, "CameraEye", "A pinhole camera of a car. The middle of the first pixel is (0, 0).")
    .def("__repr__", &shown)
    .def_readonly("name", &Eye::name)
    .def_property_readonly("width", of_pinhole(&Pinhole::width), "Pixels.")
    .def_property_readonly("height", of_pinhole(&Pinhole::height), "Pixels.")
    .def_property_readonly("focal_x", of_pinhole(&Pinhole::focal_x), "Pixels.")
    .def_property_readonly("focal_y", of_pinhole(&Pinhole::focal_y), "Pixels.")
    .def_property_readonly("middle_x", of_pinhole(&Pinhole::middle_x), "Where the axis is in the image, pixels.")
    .def_property_readonly("middle_y", of_pinhole(&Pinhole::middle_y), "Likewise.")
    .def_property_readonly("near", of_pinhole(&Pinhole::near), "What is nearer is not seen, m along the axis.")
    .def_property_readonly("far", of_pinhole(&Pinhole::far), "What is farther is not seen, m along the axis.")
    .def_property_readonly(
      "pose",
      [](const Eye & eye) {
        const auto & place = eye.pose.position;
        return py::make_tuple(place.x(), place.y(), place.z(), eye.pose.yaw());
      },
      "(x, y, z, yaw) in base_footprint, m and rad.");
}

/// Rear, front, right and left end of all that a car can touch something with.
py::tuple extentOf(const CarDescription & car)
{
  constexpr double kAnyHeight = 1e6;  // m
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec2 least{kInfinity, kInfinity};
  Vec2 greatest{-kInfinity, -kInfinity};
  const auto add = [&](const Vec2 & point, double radius) {
    least = {std::min(least.x, point.x - radius), std::min(least.y, point.y - radius)};
    greatest = {std::max(greatest.x, point.x + radius), std::max(greatest.y, point.y + radius)};
  };
  for (const Solid & solid : car.solids) {
    const Section shadow = footprintBetween(solid, solid.pose, -kAnyHeight, kAnyHeight);
    for (const Outline & outline : shadow.outlines) {
      std::for_each(outline.begin(), outline.end(), [&](const Vec2 & corner) { add(corner, 0.0); });
    }
    for (const Circle & circle : shadow.circles) {
      add(circle.centre, circle.radius);
    }
  }
  return py::make_tuple(least.x, greatest.x, least.y, greatest.y);
}

py::dict componentsOf(const CarDescription & car)
{
  py::dict components;
  for (const auto & component : car.components) {
    py::dict channels;
    for (const Channel & channel : component->channels()) {
      channels[py::str(channel.name)] = channel.size;
    }
    components[py::str(component->mount().name)] = channels;
  }
  return components;
}

py::dict camerasOf(const CarDescription & car)
{
  py::dict cameras;
  for (const auto & component : car.components) {
    if (const auto * const camera = dynamic_cast<const Camera *>(component.get())) {
      cameras[py::str(component->mount().name)] = camera->eyes();
    }
  }
  return cameras;
}

/// Nothing for a car that does not publish both its wheel odometry and the transform from it.
std::optional<std::string> odometryTopicOf(const CarDescription & car)
{
  if (!car.drive) {
    return car.ros_control ? std::nullopt : std::make_optional<std::string>("odom");
  }
  const bool is_whole = car.drive->publishes_odometry && car.drive->publishes_transform;
  return is_whole && car.drive->odometry_frame == "odom" ? std::make_optional(car.drive->odometry_topic) : std::nullopt;
}
}  // namespace

void bindCar(py::module_ & module)
{
  bindSensors(module);
  bindCameraEye(module);
  py::class_<CarDescription>(module, "Car", "A car as its robot description gives it; see load_car.")
    .def_readonly("name", &CarDescription::name)
    .def_readonly("links", &CarDescription::links, "All links of the robot description.")
    .def_readonly("lidars", &CarDescription::lidars)
    .def_readonly("bumpers", &CarDescription::bumpers)
    .def_property_readonly(
      "components", &componentsOf,
      "What else can be sampled: {name: {channel: how many numbers}}; see Simulation.sample.")
    .def_property_readonly("cameras", &camerasOf, "Its cameras: {name: [CameraEye]}; see Simulation.look.")
    .def_property_readonly(
      "joints", ofEach(&CarDescription::joints, &JointDescription::name),
      "Names of the joints whose state is published.")
    .def_readonly("wheel_radius", &CarDescription::wheel_radius, "m.")
    .def_readonly("track_width", &CarDescription::track_width, "Between the steering joints, m.")
    .def_property_readonly(
      "extent", &extentOf, "(rear, front, right, left) ends of its collisions in base_footprint, m.")
    .def_property_readonly(
      "twist_topic", &CarDescription::twistTopic,
      "Where it takes geometry_msgs/Twist; None: controllers of ros_control drive it.")
    .def_property_readonly(
      "odometry_topic", &odometryTopicOf,
      "Where it publishes the odometry of its wheels, if with the transform from 'odom'; None: nowhere.")
    .def_property_readonly(
      "takes_steering_angle",
      [](const CarDescription & car) { return car.drive && car.drive->kind == DriveDescription::Kind::kAckermann; },
      "Whether angular.z of a Twist is the angle of its wheels, not a yaw rate.")
    .def_readonly("base_frame", &CarDescription::base_frame, "The link that stands for the car.")
    .def_readonly("parameters", &CarDescription::parameters, "Dynamics as the description gives them.")
    .def_property_readonly(
      "plugins", ofEach(&CarDescription::plugins, &PluginElement::filename),
      "File names of the plugins that are not built in.")
    .def_readonly("warnings", &CarDescription::warnings, "What was left out: one line per kind.");

  module.def(
    "load_car",
    [](const std::string & xml, const std::string & name, const std::string & source) {
      return loadCar(xml, name, source, searchPathFromEnvironment());
    },
    py::arg("xml"), py::arg("name"), py::arg("source"),
    R"(Read a robot description: URDF with <gazebo> tags, or an SDF model.

Args:
    xml: the text.
    name: name of the car.
    source: what error messages call the text, for example its path.

Raises:
    LoadError: malformed text, or something that would make the simulation wrong.
)",
    py::call_guard<py::gil_scoped_release>());
}
}  // namespace f1tenth_sim2d
