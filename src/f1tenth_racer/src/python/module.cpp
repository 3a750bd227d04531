// The Python module f1tenth_racer_core: the racer and its plans, without ROS.
#include "arrays.h"

#include <workspace_support/errors.h>
#include <workspace_support/numpy_version.h>

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
      py::arg("poses"), "(n, 3) poses of the car to (n,) least distances from its outline to an obstacle, m.");
}

void bindPlanner(py::module_ & module)
{
  py::class_<Plan>(module, "Plan", "A way to a goal.")
    .def_property_readonly("found", &Plan::found)
    .def_property_readonly(
      "points", [](const Plan & plan) { return pointsOf(plan.path); },
      "(n, 5): x, y (m), yaw (rad), curvature (1/m, left is positive), s (m)")
    .def_property_readonly(
      "reverse", [](const Plan & plan) { return reverseOf(plan.path); }, "(n,): whether the car drives backwards")
    .def_readonly("expansions", &Plan::expansions, "of the search");
  py::class_<RaceLinePlanner>(module, "GlobalPlanner", "Plans paths that the car can drive.")
    .def(py::init<const PlannerOptions &>(), py::arg("options") = PlannerOptions{}, "Raises OptionError.")
    .def(
      "plan",
      [](const RaceLinePlanner & planner, const Costmap & costmap, const Doubles & start, const Doubles & goal) {
        const PlanRequest request{toPose(start, "start"), toPose(goal, "goal")};
        const py::gil_scoped_release unlocked;
        return planner.makePlan(costmap, request);
      },
      py::arg("costmap"), py::arg("start"), py::arg("goal"), "start, goal: (3,) x, y, yaw of the base frame.");
}
}  // namespace

PYBIND11_MODULE(f1tenth_racer_core, module)
{
  workspace_support::requireKnownNumpy();
  module.doc() = "The racing planner of f1tenth_racer. Lengths in m, angles in rad, times in s.";
  const auto & error = py::register_local_exception<Error>(module, "Error", PyExc_ValueError);
  py::register_local_exception<OptionError>(module, "OptionError", error);
  bindOptions(module);
  bindCostmap(module);
  bindPlanner(module);
  bindDriver(module);
}
}  // namespace f1tenth_racer
