#pragma once

#include <string>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// One contact of a car's collision element with another body, accumulated since the previous control period.
struct Contact
{
  std::string own_collision;    ///< scoped name
  std::string other_collision;  ///< scoped name
  std::string other_model;      ///< name of the model or car
  std::vector<Vec2> positions;  ///< m, world
  std::vector<Vec2> normals;    ///< unit, world, from the other body towards the car
  std::vector<double> depths;   ///< m
  Vec2 force;                   ///< N, world, on the car, mean over the time step
  double torque{0.0};           ///< N m, about the car's centre of mass
  /// m/s, of the touching points against each other before the impact, whichever of the two moved: the greatest.
  double speed{0.0};
};
}  // namespace f1tenth_sim2d
