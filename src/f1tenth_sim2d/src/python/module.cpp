#include <workspace_support/numpy_version.h>

#include "f1tenth_sim2d/errors.h"
#include "python/bindings.h"

namespace f1tenth_sim2d
{
namespace py = pybind11;

namespace
{
void bindErrors(py::module_ & module)
{
  auto error = py::register_exception<Error>(module, "Error");
  error.doc() = "Base of everything this module raises for a user's mistake.";
  auto load_error = py::register_exception<LoadError>(module, "LoadError", error.ptr());
  load_error.doc() = "A world, robot description or parameter file that cannot be used; names file, place and reason.";
}
}  // namespace

py::str shown(const py::object & object)
{
  const py::object type = py::type::of(object);
  const auto property = py::module_::import("builtins").attr("property");
  py::list properties;
  for (const auto & entry : py::dict(type.attr("__dict__"))) {
    if (py::isinstance(entry.second, property)) {
      properties.append(py::str("{}={!r}").format(entry.first, object.attr(entry.first)));
    }
  }
  return py::str("{}({})").format(type.attr("__name__"), py::str(", ").attr("join")(properties));
}
}  // namespace f1tenth_sim2d

PYBIND11_MODULE(_f1tenth_sim2d, module)
{
  workspace_support::requireKnownNumpy();
  module.doc() = "A fast and deterministic 2.5-D simulator of F1/10 cars. SI units; x forward, y left, yaw in rad.";
  f1tenth_sim2d::bindErrors(module);
  f1tenth_sim2d::bindVehicleParameters(module);
  f1tenth_sim2d::bindWorld(module);
  f1tenth_sim2d::bindCar(module);
  f1tenth_sim2d::bindSamples(module);
  f1tenth_sim2d::bindSimulation(module);
  f1tenth_sim2d::bindEnvironments(module);
}
