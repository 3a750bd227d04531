#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/random/RandomGenerators.h>

#include <utility>

#include "amcl/geometry.h"
#include "amcl/localizer_options.h"

/// Between the core's types and MRPT's.
namespace amcl
{
inline mrpt::math::TPose2D toTPose2D(const Pose2 & pose)
{
  return {pose.x, pose.y, pose.yaw};
}

inline Pose2 fromTPose2D(const mrpt::math::TPose2D & pose)
{
  return {pose.x, pose.y, pose.phi};
}

/// The map with its lower left corner at the origin and its rows along x, as MRPT moves corners to multiples of the
/// resolution and has no rotated maps. It is one unknown row and column larger.
/// @throws Error for a map without cells
mrpt::maps::COccupancyGridMap2D::Ptr toGridMap(const OccupancyGrid & grid, const LaserOptions & options);

/// The beams that are used: at most max_beams, evenly spread, those without an echo or out of range being invalid.
/// Nothing for a scan of fewer than two beams.
/// @param lidar  pose of the lidar on the car
mrpt::obs::CObservation2DRangeScan::Ptr toObservation(
  const Scan & scan, const Pose2 & lidar, const LaserOptions & options);

/// While it lives, MRPT, which has one generator for the whole process, draws from this one.
class RandomScope
{
public:
  explicit RandomScope(mrpt::random::CRandomGenerator & random) : random_(random) { swap(); }
  ~RandomScope() { swap(); }
  RandomScope(const RandomScope &) = delete;
  RandomScope & operator=(const RandomScope &) = delete;

private:
  void swap() { std::swap(mrpt::random::getRandomGenerator(), random_); }

  mrpt::random::CRandomGenerator & random_;
};
}  // namespace amcl
