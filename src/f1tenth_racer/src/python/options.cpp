#include "options.h"

#include <move_base/planning/way_planner.h>
#include "arrays.h"
#include "control/path_follower.h"
#include "control/racer_options.h"

namespace py = pybind11;

namespace f1tenth_racer
{
namespace
{
// Fields by keyword, each with the default of the struct; the names are those of the C++ struct and of the README.
template <class Options>
Options fromKeywords(const py::kwargs & values)
{
  const py::object options = py::cast(Options{});
  for (const auto & [name, value] : values) {
    if (!py::hasattr(options, name)) {
      throw py::type_error(
        py::str("unexpected option '{}' of {}").format(name, py::type::of(options).attr("__name__")));
    }
    py::setattr(options, name, value);
  }
  return options.cast<Options>();
}

template <class Options>
py::class_<Options> bindStruct(py::module_ & module, const char * name)
{
  return py::class_<Options>(module, name).def(py::init(&fromKeywords<Options>));
}

void bindPlannerOptions(py::module_ & module)
{
  bindStruct<CostmapOptions>(module, "CostmapOptions")
    .def_readwrite("allow_unknown", &CostmapOptions::allow_unknown)
    .def_readwrite("lethal_cost_threshold", &CostmapOptions::lethal_cost_threshold)
    .def_readwrite("inflation_radius", &CostmapOptions::inflation_radius, "m")
    .def_readwrite("cost_scaling_factor", &CostmapOptions::cost_scaling_factor, "1/m")
    .def_readwrite("clearance_weight", &CostmapOptions::clearance_weight);
  bindStruct<PlannerOptions>(module, "PlannerOptions")
    .def_readwrite("min_turning_radius", &PlannerOptions::min_turning_radius, "m")
    .def_readwrite("allow_reversing", &PlannerOptions::allow_reversing)
    .def_readwrite("reverse_penalty", &PlannerOptions::reverse_penalty)
    .def_readwrite("direction_penalty", &PlannerOptions::direction_penalty, "m")
    .def_readwrite("steering_penalty", &PlannerOptions::steering_penalty, "m")
    .def_readwrite("curvature_penalty", &PlannerOptions::curvature_penalty, "m")
    .def_readwrite("min_obstacle_dist", &PlannerOptions::min_obstacle_dist, "m")
    .def_readwrite("max_expansions", &PlannerOptions::max_expansions);
  bindStruct<RaceLineOptions>(module, "RaceLineOptions")
    .def_readwrite("gate_tolerance", &RaceLineOptions::gate_tolerance, "m")
    .def_readwrite("gate_yaw_tolerance", &RaceLineOptions::gate_yaw_tolerance, "rad")
    .def_readwrite("slip_gradient", &RaceLineOptions::slip_gradient, "rad per m/s^2")
    .def_readwrite("lateral_acceleration", &RaceLineOptions::lateral_acceleration, "m/s^2")
    .def_readwrite("max_speed", &RaceLineOptions::max_speed, "m/s")
    .def_property(
      "goals_beyond", [](const RaceLineOptions & options) { return fromPoses(options.goals_beyond); },
      [](RaceLineOptions & options, const Doubles & poses) { options.goals_beyond = toPoses(poses, "goals_beyond"); },
      "(N, 3) x, y, yaw of the goals that follow, in their order");
}

void bindFollowerOptions(py::module_ & module)
{
  bindStruct<SpeedLimits>(module, "SpeedLimits")
    .def_readwrite("max_vel_x", &SpeedLimits::max_vel_x, "m/s")
    .def_readwrite("max_vel_x_backwards", &SpeedLimits::max_vel_x_backwards, "m/s")
    .def_readwrite("max_vel_theta", &SpeedLimits::max_vel_theta, "rad/s")
    .def_readwrite("min_vel_x", &SpeedLimits::min_vel_x, "m/s")
    .def_readwrite("acc_lim_x", &SpeedLimits::acc_lim_x, "m/s^2")
    .def_readwrite("dec_lim_x", &SpeedLimits::dec_lim_x, "m/s^2")
    .def_readwrite("braking_power", &SpeedLimits::braking_power, "m^2/s^3")
    .def_readwrite("max_lateral_acceleration", &SpeedLimits::max_lateral_acceleration, "m/s^2")
    .def_readwrite("max_steering_angle", &SpeedLimits::max_steering_angle, "rad")
    .def_readwrite("understeer_gradient", &SpeedLimits::understeer_gradient, "rad per m/s^2")
    .def_readwrite("max_steering_rate", &SpeedLimits::max_steering_rate, "rad/s")
    .def_readwrite("wheelbase", &SpeedLimits::wheelbase, "m")
    .def_readwrite("full_speed_clearance", &SpeedLimits::full_speed_clearance, "m")
    .def_readwrite("slowest_clearance", &SpeedLimits::slowest_clearance, "m");
  bindStruct<FollowerOptions>(module, "FollowerOptions")
    .def_readwrite("limits", &FollowerOptions::limits)
    .def_readwrite("latency", &FollowerOptions::latency, "s")
    .def_readwrite("tracking_distance", &FollowerOptions::tracking_distance, "m")
    .def_readwrite("tracking_time", &FollowerOptions::tracking_time, "s")
    .def_readwrite("slip_gradient", &FollowerOptions::slip_gradient, "rad per m/s^2")
    .def_readwrite("load_transfer", &FollowerOptions::load_transfer, "per m/s^2")
    .def_readwrite("yaw_lag", &FollowerOptions::yaw_lag, "s per m/s")
    .def_readwrite("stop_clearance", &FollowerOptions::stop_clearance, "m")
    .def_readwrite("replan_distance", &FollowerOptions::replan_distance, "m")
    .def_readwrite("max_path_deviation", &FollowerOptions::max_path_deviation, "m");
}
void bindRacerOptions(py::module_ & module)
{
  bindStruct<RacerOptions>(module, "RacerOptions")
    .def_readwrite("planner", &RacerOptions::planner)
    .def_readwrite("follower", &RacerOptions::follower)
    .def_readwrite("free_goal_vel", &RacerOptions::free_goal_vel)
    .def_readwrite("race_line", &RacerOptions::race_line)
    .def_readwrite("coast_time", &RacerOptions::coast_time, "s");
}
}  // namespace

void bindOptions(py::module_ & module)
{
  bindPlannerOptions(module);
  bindFollowerOptions(module);
  bindRacerOptions(module);
}
}  // namespace f1tenth_racer
