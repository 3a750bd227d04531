#pragma once

#include <memory>
#include <stdexcept>

#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_sim2d
{
/// The only component of a kind that a car has. @throws std::runtime_error unless it has just one
template <class Kind>
Kind only(const CarDescription & car)
{
  const Kind * found = nullptr;
  for (const auto & component : car.components) {
    if (const auto * own = dynamic_cast<const Kind *>(component.get())) {
      if (found) {
        throw std::runtime_error("two of a kind");
      }
      found = own;
    }
  }
  return found ? *found : throw std::runtime_error("none of its kind");
}
}  // namespace f1tenth_sim2d
