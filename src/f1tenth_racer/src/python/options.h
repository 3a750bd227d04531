#pragma once

#include <pybind11/pybind11.h>

namespace f1tenth_racer
{
/// The structs of options, with all their fields to be read and set.
void bindOptions(pybind11::module_ & module);
}  // namespace f1tenth_racer
