#pragma once

#include <limits>
#include <vector>

#include "beam_table.h"
#include "f1tenth_sim2d/geometry.h"
#include "planar_pose.h"

namespace f1tenth_sim2d
{
/// One scan in the making: a depth buffer over the beams of a lidar, into which walls are drawn one after the other.
///
/// It holds inverse ranges, because along a straight wall the inverse range is linear in the direction of the beam:
/// two multiplications, an addition and a maximum a beam, and no division. Exact up to rounding: a wall covers
/// exactly the beams between the directions of its ends. Allocates nothing after construction.
class RangeRaster
{
public:
  explicit RangeRaster(const LidarDescription & lidar);

  /// Starts a scan from sensor, in the world.
  void begin(const Pose2 & sensor);

  /// Draws a wall from a to b, m, in the world; it is seen from its right side only, as is the outline of a solid.
  void addSegment(const Vec2 & a, const Vec2 & b);
  /// Draws a full circle, m, in the world. From inside it is not seen.
  void addCircle(const Vec2 & centre, double radius);

  /// Writes the range of beam i to ranges[i], m; +inf where nothing was drawn. May exceed rangeMax().
  void finish(double * ranges) const;

  int beamCount() const { return beams_.count(); }
  double rangeMax() const { return range_max_; }
  const Transform2 & sensor() const { return sensor_; }

private:
  template <typename Draw>
  void forEachInterval(double begin, double width, Draw draw) const;
  double beamOf(double angle) const;
  double beamOf(const Vec2 & point);

  BeamTable beams_;
  double range_max_;
  Transform2 sensor_;
  std::vector<double> inverse_ranges_;
  // The directions of neighbouring walls meet in a corner: keep the last one.
  Vec2 last_point_{std::numeric_limits<double>::quiet_NaN(), 0.0};
  double last_beam_{0.0};
};
}  // namespace f1tenth_sim2d
