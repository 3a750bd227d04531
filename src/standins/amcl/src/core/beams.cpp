#include "beams.h"

#include <workspace_support/maths/trigonometry.h>

#include <algorithm>

namespace amcl
{
namespace
{
std::size_t strideOf(const Scan & scan, int max_beams)
{
  // Rounded up, so that there are no more than that.
  const std::size_t gaps = static_cast<std::size_t>(max_beams) - 1;
  return std::max<std::size_t>(1, (scan.ranges.size() + gaps - 2) / gaps);
}
}  // namespace

Beams usedBeams(const Scan & scan, const Pose2 & lidar, const LaserOptions & options)
{
  const double nearest = options.min_range < 0.0 ? scan.range_min : options.min_range;
  const double farthest = options.max_range < 0.0 ? scan.range_max : std::min(scan.range_max, options.max_range);
  Beams used{lidar.position(), {}};
  const std::size_t stride = strideOf(scan, options.max_beams);
  for (std::size_t i = 0; i < scan.ranges.size(); i += stride) {
    const double range = scan.ranges[i];
    if (range >= nearest && range < farthest) {  // false for NaN
      const double angle = lidar.yaw + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      used.beams.push_back({{maths::cos(angle), maths::sin(angle)}, range});
    }
  }
  return used;
}
}  // namespace amcl
