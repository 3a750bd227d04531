#include "arrays.h"

#include <workspace_support/errors.h>

#include <algorithm>
#include <sstream>

namespace f1tenth_racer
{
namespace
{
namespace py = pybind11;

void requireShape(const py::array & array, const std::string & name, const std::vector<py::ssize_t> & shape)
{
  bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
  std::ostringstream allowed;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    fits = fits && (shape[i] < 0 || array.shape(static_cast<py::ssize_t>(i)) == shape[i]);
    allowed << (i == 0 ? "(" : ", ") << (shape[i] < 0 ? std::string("n") : std::to_string(shape[i]));
  }
  if (!fits) {
    const std::string found = py::str(py::tuple(array.attr("shape")));
    throw OptionError(name + ": found an array of shape " + found + ", must be " + allowed.str() + ")");
  }
}
}  // namespace

Pose2 toPose(const Doubles & array, const std::string & name)
{
  requireShape(array, name, {3});
  return {array.at(0), array.at(1), array.at(2)};
}

std::vector<Pose2> toPoses(const Doubles & array, const std::string & name)
{
  requireShape(array, name, {-1, 3});
  const auto values = array.unchecked<2>();
  std::vector<Pose2> poses;
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    poses.push_back({values(i, 0), values(i, 1), values(i, 2)});
  }
  return poses;
}

OccupancyGrid toGrid(const Cells & cells, double resolution, const Vec2 & origin)
{
  requireShape(cells, "cells", {-1, -1});
  OccupancyGrid grid;
  grid.geometry = {
    static_cast<int>(cells.shape(1)), static_cast<int>(cells.shape(0)), resolution, {origin.x, origin.y, 0.0}};
  grid.cells.assign(cells.data(), cells.data() + cells.size());
  return grid;
}

py::array_t<double> pointsOf(const Path & path)
{
  py::array_t<double> array({path.size(), std::size_t{5}});
  double * value = array.mutable_data();
  for (const PathPoint & point : path) {
    for (const double number : {point.pose.x, point.pose.y, point.pose.yaw, point.curvature, point.s}) {
      *value++ = number;
    }
  }
  return array;
}

py::array_t<bool> reverseOf(const Path & path)
{
  py::array_t<bool> array(static_cast<py::ssize_t>(path.size()));
  std::transform(path.begin(), path.end(), array.mutable_data(), [](const PathPoint & point) { return point.reverse; });
  return array;
}
}  // namespace f1tenth_racer
