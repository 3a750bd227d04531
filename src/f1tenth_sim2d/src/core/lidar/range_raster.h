#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/lidar/beam_kernels.h"
#include "core/lidar/beams.h"
#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// One scan in the making: a depth buffer over the beams of a lidar, into which walls are drawn one after the other.
///
/// It holds inverse ranges, because along a straight wall the inverse range is linear in the direction of the beam:
/// two multiplications, an addition and a maximum per beam, and no division. Exact up to rounding: a wall covers
/// exactly the beams between the directions of its ends. The order of drawing changes nothing. Walls wait until there
/// are enough of them for a vector unit, or the result is read. Allocates nothing after construction.
class RangeRaster
{
public:
  explicit RangeRaster(const Beams & beams);

  /// Starts a scan from sensor, in the world.
  /// @param range_max  m
  void begin(const Pose2 & sensor, double range_max);

  /// Draws a wall from a to b, m, in the world; it is seen from its right side only, as is the outline of a solid.
  void addSegment(const Vec2 & a, const Vec2 & b)
  {
    const Transform2 & sensor = view_.sensor;
    const Vec2 to_a{a.x - sensor.x, a.y - sensor.y};
    const Vec2 edge{b.x - a.x, b.y - a.y};
    const double cross = to_a.x * edge.y - to_a.y * edge.x;
    if (cross < 0.0 && cross * cross <= range_squared_ * (edge.x * edge.x + edge.y * edge.y)) {
      addFacing(a, b, cross);
    }
  }
  /// The same for a wall that is known to be seen.
  /// @param cross  from crossOfFacing()
  void addFacing(const Vec2 & a, const Vec2 & b, double cross)
  {
    const Transform2 & sensor = view_.sensor;
    batch_.a_x[waiting_] = a.x - sensor.x;
    batch_.a_y[waiting_] = a.y - sensor.y;
    batch_.b_x[waiting_] = b.x - sensor.x;
    batch_.b_y[waiting_] = b.y - sensor.y;
    batch_.cross[waiting_] = cross;
    if (++waiting_ == WallBatch::kSize) {
      drawWaiting();
    }
  }
  /// Draws a full circle, m, in the world. From inside it is not seen.
  void addCircle(const Vec2 & centre, double radius);

  /// Whether what lies in a circle, m, in the world, could still change the scan: not if it is out of range, out of the
  /// field of view, or behind what has been drawn.
  bool couldShow(const Vec2 & centre, double radius);
  /// How far one can see: nothing farther away, m, could still change the scan.
  double sight();

  /// Inverse ranges of all beams, 1/m; 0 where nothing was drawn. May fall below 1 / rangeMax().
  const double * inverseRanges();

  int beamCount() const { return static_cast<int>(inverse_ranges_.size()); }
  double rangeMax() const { return view_.range_max; }
  const Transform2 & sensor() const { return view_.sensor; }

private:
  template <typename Visit>
  bool anyInterval(double begin, double width, Visit visit) const;
  double beamOf(double angle) const;
  void drawWaiting();
  void drawExactly(std::size_t wall);
  void draw(std::size_t wall, int first, int last);

  BeamView view_{};
  std::vector<double> cosine_;  ///< of the beams, in the frame of the lidar
  std::vector<double> sine_;
  std::vector<double> inverse_ranges_;
  double range_squared_{0.0};  ///< m^2
  std::size_t farthest_{0};    ///< a beam that saw at least as far as any other when sight() last checked all of them
  double least_{0.0};          ///< 1/m, its inverse range then
  WallBatch batch_{};
  std::size_t waiting_{0};  ///< walls of the batch that are not drawn yet
};
}  // namespace f1tenth_sim2d
