#pragma once

#include <vector>

#include "amcl/geometry.h"
#include "amcl/localizer_options.h"
#include "beams.h"

namespace amcl
{
/// How well scans fit a map (S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics, 2005, chapter 6).
class LikelihoodField
{
public:
  /// @throws Error for a map without cells, or whose geometry makes no sense
  LikelihoodField(const OccupancyGrid & map, const LaserOptions & options);

  /// To be called before the first scan.
  /// @param range_max  m, of the lidar: beams that end anywhere are spread over it
  void setRangeMax(double range_max);

  /// Logarithm of the likelihood of what was seen from a pose of the car, by the model of the options.
  double logLikelihood(const Beams & seen, const Pose2 & pose) const;

private:
  /// Of a beam that ends at some distance from a wall.
  struct Fit
  {
    double cube;  ///< of the likelihood
    double log;
  };

  void findDistances(const OccupancyGrid & map);
  std::size_t squaredDistanceAt(const Vec2 & place) const;
  double castInGrid(const Vec2 & lidar, const Vec2 & direction) const;
  Fit fitOf(double away) const;
  template <typename Measure>
  double sum(const Beams & seen, const Pose2 & pose, Measure measure) const;

  LaserOptions options_;
  GridGeometry geometry_;
  int reach_;                         // cells; walls farther away do not count
  double range_max_{0.0};             // m
  std::vector<std::size_t> squares_;  // of each cell's distance in cells from the nearest wall
  std::vector<Fit> fits_;             // by these
};
}  // namespace amcl
