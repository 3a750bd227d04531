#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include <move_base/map/geometry.h>
#include <move_base/path/path.h>

#include "path/terms.h"

/// Between numpy arrays and the core's types.
namespace f1tenth_racer
{
using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Cells = pybind11::array_t<std::int8_t, pybind11::array::c_style>;

/// (3,): x, y, yaw. @throws OptionError
Pose2 toPose(const Doubles & array, const std::string & name);
/// (n, 3). @throws OptionError
std::vector<Pose2> toPoses(const Doubles & array, const std::string & name);

/// (height, width), row 0 at the bottom. @throws OptionError
OccupancyGrid toGrid(const Cells & cells, double resolution, const Vec2 & origin);

/// (n, 5): x, y, yaw, curvature, s; and (n,): whether driven backwards.
pybind11::array_t<double> pointsOf(const Path & path);
pybind11::array_t<bool> reverseOf(const Path & path);
}  // namespace f1tenth_racer
