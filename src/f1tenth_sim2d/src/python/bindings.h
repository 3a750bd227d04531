#pragma once

#include <pybind11/pybind11.h>

/// The parts of the Python module f1tenth_sim2d.
namespace f1tenth_sim2d
{
void bindErrors(pybind11::module_ & module);
void bindVehicleParameters(pybind11::module_ & module);
void bindWorld(pybind11::module_ & module);
void bindCar(pybind11::module_ & module);
void bindSamples(pybind11::module_ & module);
void bindSimulation(pybind11::module_ & module);
void bindEnvironments(pybind11::module_ & module);
}  // namespace f1tenth_sim2d
