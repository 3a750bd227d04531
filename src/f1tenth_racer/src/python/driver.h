#pragma once

#include <pybind11/pybind11.h>

namespace f1tenth_racer
{
/// The class Racer: drives an environment from goal to goal. To be called after bindOptions().
void bindDriver(pybind11::module_ & module);
}  // namespace f1tenth_racer
