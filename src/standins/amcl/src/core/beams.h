#pragma once

#include <vector>

#include "amcl/geometry.h"
#include "amcl/localizer_options.h"

namespace amcl
{
/// A beam that met something.
struct Beam
{
  Vec2 direction;  ///< of length 1, in the frame of the car
  double range{0.0};
};

/// What is used of a scan.
struct Beams
{
  Vec2 lidar;  ///< in the frame of the car
  std::vector<Beam> beams;
};

/// At most max_beams, evenly spread; of these, the ones with an echo within range.
/// @param lidar  pose of the lidar on the car
Beams usedBeams(const Scan & scan, const Pose2 & lidar, const LaserOptions & options);
}  // namespace amcl
