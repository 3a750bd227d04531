#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>

#include "f1tenth_sim2d/vehicle_keys.h"
#include "python/bindings.h"

namespace f1tenth_sim2d
{
namespace py = pybind11;

void bindVehicleParameters(py::module_ & module)
{
  py::class_<TireParameters> tire(
    module, "TireParameters", "Coefficients of Pacejka's magic formula, as CommonRoad names them.");
  tire.def(py::init<>()).def("__repr__", &shown);
  for (const auto & key : vehicle_keys::kTire) {
    tire.def_readwrite(key.name, key.member, key.what);
  }

  using P = VehicleParameters;
  py::class_<P> vehicle(
    module, "VehicleParameters", "Numbers of a car's dynamics, actuation and wheel odometry. SI units.");
  vehicle.def(py::init<>(), "The F1/10 car of f1tenth_gym.")
    .def("__repr__", &shown)
    .def_static(
      "load", [](const std::filesystem::path & path) { return loadVehicleParameters(path.string()); }, py::arg("path"),
      R"(Read a car's YAML file; a key that is not there keeps its default.

Raises:
    LoadError: unknown key, wrong type or value out of range, with file and line.
)")
    .def_property(
      "model", [](const P & p) { return kVehicleModelNames[static_cast<std::size_t>(p.model)]; },
      [](P & p, const std::string & name) { p.model = vehicleModel(name); },
      "How the car moves: the name of a vehicle model.")
    .def_readwrite("tire", &P::tire, "TireParameters.")
    .def_property_readonly("wheelbase", &P::wheelbase, "l_f + l_r, m.")
    .def("__copy__", [](const P & p) { return P(p); });
  for (const auto & key : vehicle_keys::kVehicle) {
    vehicle.def_readwrite(key.name, key.member, key.what);
  }
}
}  // namespace f1tenth_sim2d
