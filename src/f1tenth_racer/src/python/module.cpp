// The Python module f1tenth_racer_core: costmap, planner, speed profile and path follower, without ROS.
#include "arrays.h"

#include <workspace_support/errors.h>

#include "control/path_follower.h"
#include "driver.h"
#include "line/race_line_planner.h"
#include "options.h"

namespace py = pybind11;

namespace f1tenth_racer
{
namespace
{
void bindCostmap(py::module_ & module)
{
  py::class_<Costmap>(module, "Costmap", "Distances to obstacles of a map and of the lidar.")
    .def(
      py::init([](
                 const Cells & cells, double resolution, std::pair<double, double> origin,
                 const CostmapOptions & options, std::optional<std::vector<std::pair<double, double>>> footprint) {
        std::vector<Vec2> corners = defaultFootprint();
        if (footprint) {
          corners.clear();
          for (const auto & [x, y] : *footprint) {
            corners.push_back({x, y});
          }
        }
        return Costmap(toGrid(cells, resolution, {origin.first, origin.second}), options, Footprint(corners));
      }),
      py::arg("cells"), py::arg("resolution"), py::arg("origin") = std::pair(0.0, 0.0),
      py::arg("options") = CostmapOptions{}, py::arg("footprint") = py::none(),
      "cells: int8 (height, width), row 0 at the bottom: 0 free, 100 occupied, -1 unknown. resolution: m. origin: of\n"
      "the lower left corner, m. footprint: corners in the base frame (below the rear axle), m. Raises Error.")
    .def(
      "clearance",
      [](const Costmap & costmap, const Doubles & poses) {
        std::vector<double> clearances;
        for (const Pose2 & pose : toPoses(poses, "poses")) {
          clearances.push_back(costmap.clearance(pose));
        }
        return py::array_t<double>(static_cast<py::ssize_t>(clearances.size()), clearances.data());
      },
      py::arg("poses"), "(n, 3) poses of the car to (n,) least distances from its outline to an obstacle, m.")
    .def(
      "observe",
      [](
        Costmap & costmap, const Doubles & sensor, const py::array_t<float> & ranges, double angle_min,
        double angle_increment, double range_min, double range_max, double time) {
        const std::vector<float> values = ranges.cast<std::vector<float>>();
        costmap.observe({{angle_min, angle_increment, range_min, range_max, values}, toPose(sensor, "sensor"), time});
      },
      py::arg("sensor"), py::arg("ranges"), py::arg("angle_min"), py::arg("angle_increment"), py::arg("range_min"),
      py::arg("range_max"), py::arg("time") = 0.0,
      "Takes a scan into the map: sensor (3,) pose, ranges (n,) m, angles rad, time s: what moves is told by it.")
    .def(
      "forget", [](Costmap & costmap) { costmap.forgetAll(); }, "Forgets what the lidar saw.");
}

void bindPaths(py::module_ & module)
{
  py::class_<Path>(module, "Path", "A path of the base frame.")
    .def(py::init(&toPath), py::arg("points"), py::arg("reverse"), "points: (n, 5) as of `points`. Raises Error.")
    .def("__len__", [](const Path & path) { return path.size(); })
    .def_property_readonly("points", &pointsOf, "(n, 5): x, y (m), yaw (rad), curvature (1/m, left is positive), s (m)")
    .def_property_readonly("reverse", &reverseOf, "(n,): whether the car drives backwards from here");
  py::class_<Plan>(module, "Plan", "A way to a goal.")
    .def_property_readonly("found", &Plan::found)
    .def_property_readonly(
      "status", [](const Plan & plan) { return describe(plan.status); }, "why there is none")
    .def_readonly("path", &Plan::path)
    .def_readonly("goal_s", &Plan::goal_s, "m along the path, where the goal is")
    .def_readonly("expansions", &Plan::expansions, "of the search");
}

void bindPlanner(py::module_ & module)
{
  py::class_<GlobalPlanner>(module, "GlobalPlanner", "Plans paths that the car can drive.")
    .def(
      py::init([](const PlannerOptions & options) -> std::unique_ptr<GlobalPlanner> {
        return std::make_unique<RaceLinePlanner>(options);
      }),
      py::arg("options") = PlannerOptions{}, "Raises OptionError.")
    .def(
      "plan",
      [](
        const GlobalPlanner & planner, const Costmap & costmap, const Doubles & start, const Doubles & goal,
        double start_curvature, double extension_length, const std::optional<RaceLineOptions> & race_line) {
        const PlanRequest request{
          toPose(start, "start"), toPose(goal, "goal"), start_curvature, extension_length, race_line};
        const py::gil_scoped_release unlocked;
        return planner.makePlan(costmap, request);
      },
      py::arg("costmap"), py::arg("start"), py::arg("goal"), py::arg("start_curvature") = 0.0,
      py::arg("extension_length") = 0.0, py::arg("race_line") = py::none(),
      "start, goal: (3,) x, y, yaw of the base frame. extension_length: m wanted beyond the goal. race_line: use the\n"
      "width of the road.");
  module.def(
    "speed_profile",
    [](const Path & path, const Costmap & costmap, const SpeedLimits & limits) {
      const std::vector<double> speeds = speedProfile(path, costmap, limits);
      return py::array_t<double>(static_cast<py::ssize_t>(speeds.size()), speeds.data());
    },
    py::arg("path"), py::arg("costmap"), py::arg("limits") = SpeedLimits{},
    "(n,) greatest speed at each point of a path, m/s.");
}

void bindFollower(py::module_ & module)
{
  py::class_<FollowStep>(module, "FollowStep", "What one step of following gives.")
    .def_property_readonly(
      "speed", [](const FollowStep & step) { return step.command.speed; }, "commanded, m/s")
    .def_property_readonly(
      "curvature", [](const FollowStep & step) { return step.command.curvature; }, "1/m")
    .def_property_readonly(
      "s", [](const FollowStep & step) { return step.position.s; }, "m along the path")
    .def_property_readonly(
      "lateral", [](const FollowStep & step) { return step.position.lateral; }, "m to the left")
    .def_readonly("lost", &FollowStep::lost, "off the path")
    .def_readonly("blocked", &FollowStep::blocked, "an obstacle lies on the path")
    .def_readonly("stuck", &FollowStep::stuck, "it cannot drive on")
    .def_readonly("at_end", &FollowStep::at_end)
    .def_property_readonly(
      "prediction", [](const FollowStep & step) { return fromPoses(step.prediction); }, "(n, 3) poses to come");
  py::class_<PathFollower>(module, "PathFollower", "Steers a car along a path.")
    .def(py::init<const FollowerOptions &>(), py::arg("options") = FollowerOptions{}, "Raises OptionError.")
    .def(
      "set_path",
      [](PathFollower & follower, const Path & path, const Costmap & costmap) { follower.setPath(path, costmap); },
      py::arg("path"), py::arg("costmap"))
    .def(
      "step",
      [](
        PathFollower & follower, const Doubles & pose, double speed, const Costmap & costmap, double period,
        bool brake) {
        if (!follower.hasPath()) {
          throw Error("step: there is no path; call set_path first");
        }
        return follower.step({toPose(pose, "pose"), speed}, costmap, period, brake);
      },
      py::arg("pose"), py::arg("speed"), py::arg("costmap"), py::arg("period"), py::arg("brake") = false,
      "pose: (3,) of the base frame; speed: m/s; period: s since the last step. Raises Error without a path.");
}
}  // namespace

PYBIND11_MODULE(f1tenth_racer_core, module)
{
  module.doc() = "The planner and controller of f1tenth_racer. Lengths in m, angles in rad, times in s.";
  const auto & error = py::register_local_exception<Error>(module, "Error", PyExc_ValueError);
  py::register_local_exception<OptionError>(module, "OptionError", error);
  bindOptions(module);
  bindCostmap(module);
  bindPaths(module);
  bindPlanner(module);
  bindFollower(module);
  bindDriver(module);
}
}  // namespace f1tenth_racer
