// The Python module amcl_core: the localizer without ROS.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <workspace_support/errors.h>

#include "amcl/localizer.h"

namespace py = pybind11;

namespace amcl
{
namespace
{
using Cells = py::array_t<std::int8_t, py::array::c_style | py::array::forcecast>;
using Ranges = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Triple = std::tuple<double, double, double>;

Pose2 toPose(const Triple & triple)
{
  const auto & [x, y, yaw] = triple;
  return {x, y, yaw};
}

std::unique_ptr<Localizer> make(
  const Cells & cells, double resolution, const std::pair<double, double> & corner, const LocalizerOptions & options,
  const Triple & start, const Triple & deviations)
{
  if (cells.ndim() != 2) {
    throw Error("cells: found " + std::to_string(cells.ndim()) + " dimensions, must be 2");
  }
  OccupancyGrid map;
  map.geometry.width = static_cast<int>(cells.shape(1));
  map.geometry.height = static_cast<int>(cells.shape(0));
  map.geometry.resolution = resolution;
  map.geometry.origin = {corner.first, corner.second, 0.0};
  map.cells.assign(cells.data(), cells.data() + cells.size());
  Estimate estimate{toPose(start), {}};
  const auto & [x, y, yaw] = deviations;
  estimate.covariance[0] = x * x;
  estimate.covariance[4] = y * y;
  estimate.covariance[8] = yaw * yaw;
  estimate.validate();
  return Localizer::make(map, options, estimate);
}

bool process(
  Localizer & localizer, const Ranges & ranges, double angle_min, double angle_increment, double range_min,
  double range_max, const Triple & lidar, const Triple & odometry)
{
  Scan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = angle_increment;
  scan.range_min = range_min;
  scan.range_max = range_max;
  scan.ranges.assign(ranges.data(), ranges.data() + ranges.size());
  return localizer.process(scan, toPose(lidar), toPose(odometry)) != Outcome::kIgnored;
}

py::tuple estimate(const Localizer & localizer)
{
  const Estimate estimate = localizer.estimate();
  py::array_t<double> covariance({py::ssize_t{3}, py::ssize_t{3}});
  std::copy(estimate.covariance.begin(), estimate.covariance.end(), covariance.mutable_data());
  return py::make_tuple(Triple{estimate.pose.x, estimate.pose.y, estimate.pose.yaw}, covariance);
}
}  // namespace
}  // namespace amcl

PYBIND11_MODULE(amcl_core, module)
{
  using namespace amcl;
  module.doc() = "The localizer of amcl without ROS. Lengths in m, angles in rad.";
  py::register_local_exception<Error>(module, "Error", PyExc_ValueError);
  py::enum_<OdometryModel>(module, "OdometryModel", "Named as the values of the parameter odom_model_type.")
    .value("diff", OdometryModel::kDiff)
    .value("omni", OdometryModel::kOmni)
    .value("diff-corrected", OdometryModel::kDiffCorrected)
    .value("omni-corrected", OdometryModel::kOmniCorrected);
  py::enum_<LaserModel>(module, "LaserModel", "Named as the values of the parameter laser_model_type.")
    .value("beam", LaserModel::kBeam)
    .value("likelihood_field", LaserModel::kLikelihoodField)
    .value("likelihood_field_prob", LaserModel::kLikelihoodFieldProb);
  py::class_<OdometryOptions>(module, "OdometryOptions", "Names of amcl's parameters without odom_ and _type.")
    .def(py::init<>())
    .def_readwrite("model", &OdometryOptions::model)
    .def_readwrite("alpha1", &OdometryOptions::alpha1)
    .def_readwrite("alpha2", &OdometryOptions::alpha2)
    .def_readwrite("alpha3", &OdometryOptions::alpha3)
    .def_readwrite("alpha4", &OdometryOptions::alpha4)
    .def_readwrite("alpha5", &OdometryOptions::alpha5);
  py::class_<LaserOptions>(module, "LaserOptions", "Names of amcl's parameters without laser_ and _type.")
    .def(py::init<>())
    .def_readwrite("model", &LaserOptions::model)
    .def_readwrite("max_beams", &LaserOptions::max_beams)
    .def_readwrite("min_range", &LaserOptions::min_range, "m")
    .def_readwrite("max_range", &LaserOptions::max_range, "m")
    .def_readwrite("z_hit", &LaserOptions::z_hit)
    .def_readwrite("z_rand", &LaserOptions::z_rand)
    .def_readwrite("sigma_hit", &LaserOptions::sigma_hit, "m")
    .def_readwrite("likelihood_max_dist", &LaserOptions::likelihood_max_dist, "m");
  py::class_<LocalizerOptions>(module, "LocalizerOptions", "Names and defaults of amcl's parameters.")
    .def(py::init<>())
    .def_readwrite("odometry", &LocalizerOptions::odometry)
    .def_readwrite("laser", &LocalizerOptions::laser)
    .def_readwrite("min_particles", &LocalizerOptions::min_particles)
    .def_readwrite("max_particles", &LocalizerOptions::max_particles)
    .def_readwrite("kld_err", &LocalizerOptions::kld_err)
    .def_readwrite("kld_z", &LocalizerOptions::kld_z)
    .def_readwrite("update_min_d", &LocalizerOptions::update_min_d, "m")
    .def_readwrite("update_min_a", &LocalizerOptions::update_min_a, "rad")
    .def_readwrite("resample_interval", &LocalizerOptions::resample_interval, "scans")
    .def_readwrite("seed", &LocalizerOptions::seed);
  py::class_<Localizer>(module, "Localizer", "Finds out where a car is on a map, from scans and odometry.")
    .def(
      py::init(&make), py::arg("cells"), py::arg("resolution"), py::arg("corner"), py::arg("options"), py::arg("start"),
      py::arg("deviations"),
      "cells of shape (height, width), row 0 at the bottom: 0 free, 100 occupied, -1 unknown; m per cell; (x, y) of "
      "the "
      "map's corner; start is (x, y, yaw) of the car, deviations how sure that is. Raises Error for what makes no "
      "sense.")
    .def("spread_out", &Localizer::spreadOut, "Forgets where the car is. Raises Error if nothing is free on the map.")
    .def(
      "process", &process, py::arg("ranges"), py::arg("angle_min"), py::arg("angle_increment"), py::arg("range_min"),
      py::arg("range_max"), py::arg("lidar"), py::arg("odometry"),
      "Takes a scan in: ranges of shape (n,), m; lidar is (x, y, yaw) of the lidar on the car, odometry of the car. "
      "Returns whether it counted.")
    .def(
      "estimate", &estimate,
      "As of the last scan that counted: (x, y, yaw) of the car on the map, and its covariance, float64 of shape "
      "(3, 3) in m^2, m rad and rad^2.");
}
