#include "sight.h"

#include <cmath>

namespace amcl
{
namespace
{
constexpr double kViewInterval = 0.5;  // m between scans that are kept
// m; over a longer way odometry distorts what was seen.
constexpr double kLength = 4.0;

Points endsOf(const mrpt::obs::CObservation2DRangeScan & scan)
{
  const mrpt::poses::CPose2D lidar(scan.sensorPose);
  const double step = (scan.rightToLeft ? 1.0 : -1.0) * scan.aperture / (scan.getScanSize() - 1.0);
  Points ends;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    if (scan.getScanRangeValidity(i)) {
      const double angle = lidar.phi() + step * (i - 0.5 * (scan.getScanSize() - 1.0));
      const double range = scan.getScanRange(i);
      ends.push_back({lidar.x() + range * std::cos(angle), lidar.y() + range * std::sin(angle)});
    }
  }
  return ends;
}
}  // namespace

void Sight::add(const mrpt::obs::CObservation2DRangeScan & scan, const Pose2 & odometry)
{
  last_ = {odometry, endsOf(scan)};
  if (views_.empty() || distance(views_.back().odometry, odometry) >= kViewInterval) {
    views_.push_back(last_);
  }
  while (distance(views_.front().odometry, odometry) > kLength) {
    views_.pop_front();
  }
}

Points Sight::points() const
{
  Points points = last_.ends;
  for (const View & view : views_) {
    const Pose2 from = compose(inverse(last_.odometry), view.odometry);
    for (const Vec2 & end : view.ends) {
      points.push_back(transform(from, end));
    }
  }
  return points;
}
}  // namespace amcl
