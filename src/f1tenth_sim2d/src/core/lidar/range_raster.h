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
/// exactly the beams between the directions of its ends. The order of drawing changes nothing. Allocates nothing after construction.
class RangeRaster
{
public:
  explicit RangeRaster(const Beams & beams);

  /// Starts a scan from sensor, in the world.
  /// @param range_max  m
  void begin(const Pose2 & sensor, double range_max);

  /// Draws walls, each seen from its right side only, as is the outline of a solid.
  /// @param count      at most SeenWalls::kMost
  /// @param is_wanted  asked for the index of each wall that would be drawn
  template <typename IsWanted>
  void addWalls(const WallEnds & walls, std::size_t count, IsWanted is_wanted)
  {
    projectWalls(view_, walls, count, seen_);
    for (std::size_t i = 0; i < count; ++i) {
      if (seen_.kind[i] != SeenWalls::kHidden && is_wanted(i)) {
        drawSeen(walls, i);
      }
    }
  }
  /// Draws a full circle, m, in the world. From inside it is not seen.
  void addCircle(const Vec2 & centre, double radius);

  /// Whether what lies in a circle, m, in the world, could still change the scan: not if it is out of range, out of the
  /// field of view, or behind what has been drawn.
  bool couldShow(const Vec2 & centre, double radius) const;
  /// How far one can see: nothing farther away, m, could still change the scan.
  double sight();

  /// Inverse ranges of all beams, 1/m; 0 where nothing was drawn. May fall below 1 / rangeMax().
  const double * inverseRanges() const { return inverse_ranges_.data(); }

  int beamCount() const { return static_cast<int>(inverse_ranges_.size()); }
  double rangeMax() const { return view_.range_max; }
  const Transform2 & sensor() const { return view_.sensor; }

private:
  template <typename Visit>
  bool anyInterval(double begin, double width, Visit visit) const;
  double beamOf(double angle) const;
  void drawSeen(const WallEnds & walls, std::size_t wall);
  void drawExactly(const WallEnds & walls, std::size_t wall);
  void draw(std::size_t wall, int first, int last);

  BeamView view_{};
  std::vector<double> cosine_;  ///< of the beams, in the frame of the lidar
  std::vector<double> sine_;
  std::vector<double> inverse_ranges_;
  std::size_t unseeing_{0};  ///< the first beam that had seen nothing when sight() last looked
  SeenWalls seen_{};         ///< that are being drawn
};
}  // namespace f1tenth_sim2d
