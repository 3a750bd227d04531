#include "options.h"

#include <move_base/planning/way_planner.h>

#include <string>
#include <type_traits>

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
    .def_readwrite("cost_scaling_factor", &CostmapOptions::cost_scaling_factor, "1/m");
  bindStruct<PlannerOptions>(module, "PlannerOptions")
    .def_readwrite("min_turning_radius", &PlannerOptions::min_turning_radius, "m")
    .def_readwrite("allow_reversing", &PlannerOptions::allow_reversing)
    .def_readwrite("min_obstacle_dist", &PlannerOptions::min_obstacle_dist, "m")
    .def_readwrite("max_expansions", &PlannerOptions::max_expansions);
}

// Each option under its name, with its meaning.
void bindEach(py::class_<RacerOptions> & binding)
{
  RacerOptions defaults;
  RacerOptions::visitEach(defaults, [&](const Option & option, auto & value) {
    using Value = std::decay_t<decltype(value)>;
    const std::string name = option.name;
    const auto get = [name](const RacerOptions & options) {
      Value found{};
      RacerOptions::visitEach(options, [&](const Option & each, const auto & at) {
        if constexpr (std::is_same_v<std::decay_t<decltype(at)>, Value>) {
          found = each.name == name ? at : found;
        }
      });
      return found;
    };
    const auto set = [name](RacerOptions & options, Value wanted) {
      RacerOptions::visitEach(options, [&](const Option & each, auto & at) {
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
  auto racer = bindStruct<RacerOptions>(module, "RacerOptions");
  racer.def_readwrite("planner", &RacerOptions::planner);
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
