#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "render/camera.h"

namespace f1tenth_sim2d
{
/// An array with a row for each item and a column for each of the numbers that an item consists of.
/// @tparam Item  all its members must be doubles, which cannot be checked here
template <typename Item>
pybind11::array_t<double> toArray(const std::vector<Item> & items)
{
  static_assert(std::is_trivially_copyable_v<Item> && alignof(Item) == alignof(double));
  const std::array<std::size_t, 2> shape{items.size(), sizeof(Item) / sizeof(double)};
  return pybind11::array_t<double>(shape, reinterpret_cast<const double *>(items.data()));
}

/// Colour, of shape (height, width, 3), and depth, of shape (height, width); both keep the picture.
inline pybind11::tuple toArrays(Picture picture)
{
  namespace py = pybind11;
  auto kept = std::make_unique<Picture>(std::move(picture));
  Picture & seen = *kept;
  const py::capsule owner(kept.release(), [](void * each) { delete static_cast<Picture *>(each); });
  const py::array_t<std::uint8_t> colours({seen.height, seen.width, 3}, seen.colours.data(), owner);
  const py::array_t<float> depths({seen.height, seen.width}, seen.depths.data(), owner);
  return py::make_tuple(colours, depths);
}
}  // namespace f1tenth_sim2d
