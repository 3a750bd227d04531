#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>

#include "f1tenth_sim2d/simulation_types.h"

namespace pybind11::detail
{
/// Python has a CarId as an int.
template <>
struct type_caster<f1tenth_sim2d::CarId>
{
  PYBIND11_TYPE_CASTER(f1tenth_sim2d::CarId, const_name("int"));

  bool load(handle source, bool convert)
  {
    make_caster<std::uint32_t> number;
    if (!number.load(source, convert)) {
      return false;
    }
    value = f1tenth_sim2d::CarId{cast_op<std::uint32_t>(number)};
    return true;
  }

  static handle cast(f1tenth_sim2d::CarId id, return_value_policy policy, handle parent)
  {
    return make_caster<std::uint32_t>::cast(static_cast<std::uint32_t>(id), policy, parent);
  }
};
}  // namespace pybind11::detail
