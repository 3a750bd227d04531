#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <deque>

#include "amcl/geometry.h"
#include "fit_field.h"

namespace amcl
{
/// What a car has seen on the last metres of its way.
class Sight
{
public:
  /// @param odometry  pose of the car according to odometry
  void add(const mrpt::obs::CObservation2DRangeScan & scan, const Pose2 & odometry);
  /// Where beams have ended, in the frame of the car at the last scan.
  Points points() const;

private:
  struct View
  {
    Pose2 odometry;
    Points ends;  // of the beams, in the frame of the car
  };

  std::deque<View> views_;
  View last_;
};
}  // namespace amcl
