#pragma once

#include <optional>
#include <string>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// The first point of the track's centreline, headed for the second: of X_centerline.csv beside X_map.yaml, in the
/// format of f1tenth_racetracks (`# x_m, y_m, …`, m). Nothing if there is no such file.
/// @throws LoadError naming file and line
std::optional<Pose2> startOnCentreline(const std::string & map_path);
}  // namespace f1tenth_sim2d
