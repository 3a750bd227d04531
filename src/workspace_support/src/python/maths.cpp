#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "workspace_support/maths/exponential.h"
#include "workspace_support/maths/trigonometry.h"
#include "workspace_support/numpy_version.h"

namespace py = pybind11;
namespace maths = workspace_support::maths;

PYBIND11_MODULE(_maths, module)
{
  workspace_support::requireKnownNumpy();
  module.def("sin", py::vectorize(maths::sin));
  module.def("cos", py::vectorize(maths::cos));
  module.def("tan", py::vectorize(maths::tan));
  module.def("asin", py::vectorize(maths::asin));
  module.def("acos", py::vectorize(maths::acos));
  module.def("atan", py::vectorize(maths::atan));
  module.def("atan2", py::vectorize(maths::atan2), py::arg("y"), py::arg("x"));
  module.def("exp", py::vectorize(maths::exp));
  module.def("log", py::vectorize(maths::log));
  module.def("pow", py::vectorize(maths::pow), py::arg("x"), py::arg("y"));
  module.def("cbrt", py::vectorize(maths::cbrt));
  module.def("hypot", py::vectorize(maths::hypot), py::arg("x"), py::arg("y"));
}
