#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Points as an array of shape (n, 2).
inline pybind11::array_t<double> toArray(const std::vector<Vec2> & points)
{
  pybind11::array_t<double> array({static_cast<pybind11::ssize_t>(points.size()), pybind11::ssize_t{2}});
  auto cells = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<pybind11::ssize_t>(i);
    cells(row, 0) = points[i].x;
    cells(row, 1) = points[i].y;
  }
  return array;
}
}  // namespace f1tenth_sim2d
