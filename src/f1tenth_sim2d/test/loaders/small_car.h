#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace f1tenth_sim2d
{
inline std::string smallCar()
{
  std::ifstream file(F1TENTH_SIM2D_TEST_DATA "/small_car.urdf");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The small car with the first occurrence of a piece of text replaced.
inline std::string smallCarWith(const std::string & before, const std::string & after)
{
  std::string text = smallCar();
  const std::size_t at = text.find(before);
  if (at == std::string::npos) {
    throw std::logic_error("the small car has no " + before);
  }
  return text.replace(at, before.size(), after);
}
}  // namespace f1tenth_sim2d
