#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

/// The parts of the Python module f1tenth_sim2d.
namespace f1tenth_sim2d
{
/// Reads a text from each item of a list.
template <typename Owner, typename Item>
auto ofEach(std::vector<Item> Owner::*items, std::string Item::*text)
{
  return [items, text](const Owner & owner) {
    std::vector<std::string> texts;
    for (const Item & item : owner.*items) {
      texts.push_back(item.*text);
    }
    return texts;
  };
}

/// "TYPE(NAME=VALUE, ...)" of the properties of a bound object, in the order in which they are bound: its __repr__.
pybind11::str shown(const pybind11::object & object);

void bindVehicleParameters(pybind11::module_ & module);
void bindWorld(pybind11::module_ & module);
void bindCar(pybind11::module_ & module);
void bindSamples(pybind11::module_ & module);
void bindSimulation(pybind11::module_ & module);
void bindEnvironments(pybind11::module_ & module);
}  // namespace f1tenth_sim2d
