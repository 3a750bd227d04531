#pragma once

#include <memory>

#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
/// What a component publishes: the message of its kind; for a kind without one its numbers, as
/// std_msgs/Float64MultiArray with a dimension per channel. Null for one that measures nothing.
/// @param component  of the car, as long as the output exists
std::unique_ptr<Output> makeOutput(const CarHandle & car, const Component & component);
}  // namespace f1tenth_sim2d
