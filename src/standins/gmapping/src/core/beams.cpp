#include "beams.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

namespace gmapping
{
std::vector<Beam> hitBeams(const Scan & scan, double max_range)
{
  std::vector<Beam> beams;
  beams.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (range >= scan.range_min && range < max_range) {  // false for NaN
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      beams.push_back({static_cast<float>(maths::cos(angle)), static_cast<float>(maths::sin(angle)), scan.ranges[i]});
    }
  }
  return beams;
}

std::vector<Vec2> endsOf(const std::vector<Beam> & beams)
{
  std::vector<Vec2> ends(beams.size());
  std::transform(beams.begin(), beams.end(), ends.begin(), [](const Beam & beam) {
    return Vec2{static_cast<double>(beam.range) * beam.cos, static_cast<double>(beam.range) * beam.sin};
  });
  return ends;
}

void registerBeams(CellMap & map, const std::vector<Beam> & beams, const Pose2 & pose, double max_urange)
{
  map.grow({pose.x, pose.y}, max_urange);
  const BeamCaster caster(pose);
  for (const Beam & beam : beams) {
    const Vec2 end = caster.along(caster.direction(beam), std::min<double>(beam.range, max_urange));
    map.addBeam({pose.x, pose.y}, end, beam.range <= max_urange);
  }
}
}  // namespace gmapping
