// The Python module gmapping_core: the mapper without ROS.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <workspace_support/errors.h>

#include "gmapping/grid_slam.h"

namespace py = pybind11;

namespace gmapping
{
namespace
{
using Ranges = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Triple = std::tuple<double, double, double>;

bool process(
  GridSlam & slam, const Ranges & ranges, double angle_min, double angle_increment, double range_min, double range_max,
  const Triple & odometry, double time)
{
  Scan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = angle_increment;
  scan.range_min = range_min;
  scan.range_max = range_max;
  scan.ranges.assign(ranges.data(), ranges.data() + ranges.size());
  const auto & [x, y, yaw] = odometry;
  return slam.process(scan, {x, y, yaw}, time);
}

py::tuple map(GridSlam & slam)
{
  const OccupancyGrid grid = slam.map();
  py::array_t<std::int8_t> cells({grid.geometry.height, grid.geometry.width});
  std::copy(grid.cells.begin(), grid.cells.end(), cells.mutable_data());
  const Pose2 & corner = grid.geometry.origin;
  return py::make_tuple(cells, grid.geometry.resolution, py::make_tuple(corner.x, corner.y));
}

Triple pose(const GridSlam & slam)
{
  const Pose2 pose = slam.pose();
  return {pose.x, pose.y, pose.yaw};
}

py::array_t<double> path(const GridSlam & slam)
{
  py::array_t<double> poses({static_cast<py::ssize_t>(slam.path().size()), py::ssize_t{3}});
  double * value = poses.mutable_data();
  for (const Pose2 & pose : slam.path()) {
    *value++ = pose.x;
    *value++ = pose.y;
    *value++ = pose.yaw;
  }
  return poses;
}
}  // namespace
}  // namespace gmapping

PYBIND11_MODULE(gmapping_core, module)
{
  using namespace gmapping;
  module.doc() = "The mapper of slam_gmapping without ROS. Lengths in m, angles in rad, times in s.";
  py::register_local_exception<Error>(module, "Error", PyExc_ValueError);
  py::class_<MotionNoise>(module, "MotionNoise", "How odometry errs.")
    .def(py::init<>())
    .def_readwrite("srr", &MotionNoise::srr, "m per m")
    .def_readwrite("srt", &MotionNoise::srt, "rad per m")
    .def_readwrite("str", &MotionNoise::str, "m per rad")
    .def_readwrite("stt", &MotionNoise::stt, "rad per rad");
  py::class_<MatcherOptions>(module, "MatcherOptions", "How a scan is laid onto a map.")
    .def(py::init<>())
    .def_readwrite("sigma", &MatcherOptions::sigma, "m")
    .def_readwrite("kernel_size", &MatcherOptions::kernel_size, "cells")
    .def_readwrite("iterations", &MatcherOptions::iterations)
    .def_readwrite("lskip", &MatcherOptions::lskip, "beams")
    .def_readwrite("minimum_score", &MatcherOptions::minimum_score, "beams");
  py::class_<SlamOptions>(module, "SlamOptions", "Names and defaults of slam_gmapping's parameters.")
    .def(py::init<>())
    .def_readwrite("motion", &SlamOptions::motion)
    .def_readwrite("matcher", &SlamOptions::matcher)
    .def_readwrite("max_range", &SlamOptions::max_range, "m, or None")
    .def_readwrite("max_urange", &SlamOptions::max_urange, "m, or None")
    .def_readwrite("linear_update", &SlamOptions::linear_update, "m")
    .def_readwrite("angular_update", &SlamOptions::angular_update, "rad")
    .def_readwrite("temporal_update", &SlamOptions::temporal_update, "s")
    .def_readwrite("xmin", &SlamOptions::xmin, "m")
    .def_readwrite("ymin", &SlamOptions::ymin, "m")
    .def_readwrite("xmax", &SlamOptions::xmax, "m")
    .def_readwrite("ymax", &SlamOptions::ymax, "m")
    .def_readwrite("delta", &SlamOptions::delta, "m per cell")
    .def_readwrite("occ_thresh", &SlamOptions::occ_thresh);
  py::class_<GridSlam>(module, "GridSlam", "Builds a map from scans and odometry.")
    .def(py::init(&GridSlam::make), py::arg("options"), "Raises Error for an option that is out of range.")
    .def(
      "process", &process, py::arg("ranges"), py::arg("angle_min"), py::arg("angle_increment"), py::arg("range_min"),
      py::arg("range_max"), py::arg("odometry"), py::arg("time"),
      "Takes a scan in: ranges of shape (n,), m; odometry is (x, y, yaw) of the lidar. Returns whether it counted.")
    .def_property_readonly("pose", &pose, "(x, y, yaw) of the lidar in the map as of the last scan that counted.")
    .def_property_readonly("path", &path, "Poses of the lidar at all scans that counted, float64 of shape (n, 3).")
    .def(
      "map", &map, "(cells as int8 of shape (height, width), row 0 at the bottom; m per cell; (x, y) of its corner).");
}
