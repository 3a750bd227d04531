#include "f1tenth_sim2d/errors.h"

#include "python/bindings.h"

namespace f1tenth_sim2d
{
void bindErrors(pybind11::module_ & module)
{
  auto error = pybind11::register_exception<Error>(module, "Error");
  error.doc() = "Base of everything this module raises for a user's mistake.";
  auto load_error = pybind11::register_exception<LoadError>(module, "LoadError", error.ptr());
  load_error.doc() = "A world, robot description or parameter file that cannot be used; names file, place and reason.";
}
}  // namespace f1tenth_sim2d
