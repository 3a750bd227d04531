#pragma once

#include <pybind11/pybind11.h>

namespace f1tenth_sim2d
{
/// "TYPE(NAME=VALUE, ...)" of the properties of a bound object, in the order in which they are bound: its __repr__.
pybind11::str shown(const pybind11::object & object);
}  // namespace f1tenth_sim2d
