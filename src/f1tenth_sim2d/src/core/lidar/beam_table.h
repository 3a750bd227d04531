#pragma once

#include <vector>

#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_sim2d
{
/// Directions of a lidar's beams in its own frame, as arrays that a loop over beams can stream.
struct BeamTable
{
  explicit BeamTable(const LidarDescription & lidar);

  int count() const { return static_cast<int>(cosine.size()); }

  double angle_min;         ///< rad
  double beams_per_radian;  ///< 1 / angle between beams
  double beams_per_turn;    ///< beams that a full turn would have, not a whole number in general
  std::vector<double> cosine;
  std::vector<double> sine;
};
}  // namespace f1tenth_sim2d
