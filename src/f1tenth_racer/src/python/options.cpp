#include "options.h"

#include <move_base/planning/way_planner.h>

#include <string>
#include <type_traits>

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

// Each option of a struct under its name, with its meaning.
template <class Options>
void bindEach(py::class_<Options> & binding)
{
  Options defaults;
  Options::visitEach(defaults, [&](const Option & option, auto & value) {
    using Value = std::decay_t<decltype(value)>;
    const std::string name = option.name;
    const auto get = [name](const Options & options) {
      Value found{};
      Options::visitEach(options, [&](const Option & each, const auto & at) {
        if constexpr (std::is_same_v<std::decay_t<decltype(at)>, Value>) {
          found = each.name == name ? at : found;
        }
      });
      return found;
    };
    const auto set = [name](Options & options, Value wanted) {
      Options::visitEach(options, [&](const Option & each, auto & at) {
        if constexpr (std::is_same_v<std::decay_t<decltype(at)>, Value>) {
          at = each.name == name ? wanted : at;
        }
      });
    };
    binding.def_property(option.name, get, set, option.meaning);
  });
}

// Name, unit, meaning, default and range of each.
py::list tableOf(const RacerOptions & options)
{
  py::list table;
  RacerOptions::visitEach(options, [&](const Option & option, const auto & value) {
    const bool is_switch = std::is_same_v<std::decay_t<decltype(value)>, bool>;
    table.append(py::make_tuple(
      option.name, option.unit, option.meaning, value, is_switch ? "true or false" : describe(option.range)));
  });
  return table;
}

void bindRacerOptions(py::module_ & module)
{
  auto limits = bindStruct<SpeedLimits>(module, "SpeedLimits");
  bindEach(limits);
  auto follower = bindStruct<FollowerOptions>(module, "FollowerOptions");
  follower.def_readwrite("limits", &FollowerOptions::limits);
  bindEach(follower);
  auto racer = bindStruct<RacerOptions>(module, "RacerOptions");
  racer.def_readwrite("planner", &RacerOptions::planner).def_readwrite("follower", &RacerOptions::follower);
  bindEach(racer);
  racer.def_static(
    "table", [] { return tableOf(RacerOptions{}); }, "(name, unit, meaning, default, range) of each option.");
}
}  // namespace

void bindOptions(py::module_ & module)
{
  bindPlannerOptions(module);
  bindRacerOptions(module);
}
}  // namespace f1tenth_racer
