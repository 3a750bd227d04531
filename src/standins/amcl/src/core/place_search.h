#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include "amcl/geometry.h"
#include "fit_field.h"

namespace amcl
{
/// Where the car may be.
struct Place
{
  Pose2 pose;
  double fit{0.0};  ///< of what was seen: 0 to 1
};

/// Steps in which a place is moved to a better one.
struct Steps
{
  double length;  ///< m, of the first one
  double turn;    ///< rad
  int most;
};

/// Keeps the best ones that are not beside a better one, best first.
void keepPeaks(std::vector<Place> & places, std::size_t count);

/// Finds where on a map a car has to be for walls to lie where it has seen them.
class PlaceSearch
{
public:
  explicit PlaceSearch(const mrpt::maps::COccupancyGridMap2D & map);

  /// Looks everywhere on the road, in every direction.
  /// @param seen  points of walls in the frame of the car
  /// @return      where they fit best; best first; none if they fit nowhere
  std::vector<Place> everywhere(const Points & road, const Points & seen) const;
  /// Looks about these places only.
  std::vector<Place> about(const std::vector<Pose2> & poses, const Points & seen) const;
  /// The place next to this one, hardly farther than odometry errs on a few metres, where what was seen fits best.
  Place near(const Pose2 & pose, const Points & seen) const;

private:
  std::vector<Place> settle(std::vector<Place> places, const Points & seen) const;

  void climb(const Points & seen, Place & place, Steps steps) const;

  double cell_;  // m
  FitField field_;
  Fit coarse_;
  Fit middle_;
  Fit fine_;
};
}  // namespace amcl
