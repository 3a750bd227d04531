#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cell_map.h"
#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"
#include "moments.h"

namespace gmapping
{
/// Where a pose is believed to be: x (m), y (m), yaw (rad) in the map, and the inverse of their covariance.
struct PoseBelief
{
  Pose2 mean;
  Eigen::Matrix3d information{Eigen::Matrix3d::Zero()};
};

/// Turns the first two of three coordinates, as Eigen does, but with the same bits on every processor.
Eigen::Matrix3d turnMatrix(double yaw);

/// Cell size of the maps that scans are matched to, m, whatever the cells of the published map are: with cells of 5 cm
/// the heading drifts twice as fast.
constexpr double kMatchingCell = 0.02;

/// Matches scans to a map: where beams end near a straight wall, they pull the scan onto it, the more the
/// better the wall is known.
class ScanMatcher
{
public:
  explicit ScanMatcher(const MatcherOptions & options) : options_(options) {}

  /// What scan and odometry say together: Gauss-Newton on the distances of the beams' ends from the walls.
  /// @param ends      where beams ended, in the lidar's frame, m; of one scan, or of several moved into that frame
  /// @param expected  what odometry says
  PoseBelief match(const CellMap & map, const std::vector<Vec2> & ends, const PoseBelief & expected) const;
  /// How well a scan fits: 1 for each beam that ends on a wall, less for the others.
  double score(const CellMap & map, const std::vector<Vec2> & ends, const Pose2 & pose) const;

private:
  struct Wall
  {
    Vec2 offset;  // of the wall from the beam's end, m
    Vec2 normal;
    double trust;                                                                  // 0 to 1: how well it is known
    double distance() const { return offset.x * normal.x + offset.y * normal.y; }  // m
  };

  PoseBelief step(
    const CellMap & map, const std::vector<Vec2> & ends, const PoseBelief & expected, const Pose2 & pose,
    double sigma) const;
  std::optional<Wall> wallNear(const CellMap & map, const Vec2 & place) const;
  /// Means of the hits of wall cells about a cell, seen from a place (m).
  Moments wallAround(const CellMap & map, const Cell & centre, const Vec2 & place) const;
  template <class Visit>
  void forEachWallCell(const CellMap & map, const Cell & centre, Visit visit) const;
  template <class Visit>
  void forEachEnd(const std::vector<Vec2> & ends, const Pose2 & pose, Visit visit) const;

  MatcherOptions options_;
};
}  // namespace gmapping
