#pragma once

#include <cstdint>

namespace f1tenth_sim2d
{
/// A car of one Simulation, from addCar() to removeCar(). Cars are numbered from 0 in the order in which they come; the
/// number of a car that has left is never given to another one.
enum class CarId : std::uint32_t
{
};
}  // namespace f1tenth_sim2d
