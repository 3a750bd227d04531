#pragma once

#include <vector>

#include "amcl/geometry.h"
#include "place_search.h"
#include "sight.h"

namespace amcl
{
/// Looks for a car that is lost, again and again on its way, until there is only one place where it can be.
class LostCar
{
public:
  /// It may be anywhere on a road.
  LostCar(const mrpt::maps::COccupancyGridMap2D & map, Points road);
  /// It is at one of these poses, or near one.
  LostCar(const mrpt::maps::COccupancyGridMap2D & map, std::vector<Pose2> poses);

  /// Processes a scan.
  /// @param odometry  pose of the car according to odometry
  /// @return          places of the car, each with its share of what is likely; empty if this was not worth a look
  std::vector<Place> look(const mrpt::obs::CObservation2DRangeScan & scan, const Pose2 & odometry);
  /// Whether it need not be looked for any longer.
  bool isOver() const { return is_over_; }

private:
  struct Look
  {
    Pose2 odometry;
    Points seen;  // in the frame of the car
  };

  std::vector<Place> find() const;
  void remember(std::vector<Place> & places) const;

  PlaceSearch search_;
  Points road_;
  std::vector<Pose2> poses_;  // where the car may have been at the last look
  Sight sight_;
  std::vector<Look> looks_;  // all of them
  std::size_t certain_{0};   // looks in a row that found one place
  bool is_over_{false};
};
}  // namespace amcl
