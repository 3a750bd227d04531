#pragma once

#include <memory>
#include <vector>

#include "amcl/estimate.h"
#include "amcl/geometry.h"
#include "amcl/localizer_options.h"

namespace amcl
{
/// What became of a scan.
enum class Outcome
{
  kIgnored,    ///< the car has hardly moved since the last one that counted
  kUpdated,    ///< the particles were moved and weighted
  kResampled,  ///< they were resampled, too
};

/// Finds out where a car is on a map, from scans and odometry: Monte-Carlo localization with as many particles as needed.
/// The same inputs and the same seed give the same poses, on every machine.
class Localizer
{
public:
  /// @param start  valid
  /// @throws Error for a map without cells, or whose geometry makes no sense
  static std::unique_ptr<Localizer> make(
    const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start);
  virtual ~Localizer() = default;

  /// Replaces what it believes by an estimate from outside, which is valid. The next scan counts.
  virtual void setPose(const Estimate & estimate) = 0;
  /// Forgets where the car is: it may be anywhere that is free on the map. The next scan counts.
  /// @throws Error if nothing is free there
  virtual void spreadOut() = 0;
  /// Makes the next scan count even if the car stands.
  virtual void updateNext() = 0;

  /// Processes a scan.
  /// @param lidar     pose of the lidar on the car
  /// @param odometry  pose of the car when the scan was taken, according to odometry
  /// @throws Error for a scan that does not say where its beams are, or is more than 1000 km from the last; it changes
  /// nothing
  virtual Outcome process(const Scan & scan, const Pose2 & lidar, const Pose2 & odometry) = 0;

  /// Mean of the heaviest group of particles, as of the last scan that counted, and its covariance.
  virtual Estimate estimate() const = 0;
  /// In the map frame.
  virtual std::vector<Pose2> particles() const = 0;
};
}  // namespace amcl
