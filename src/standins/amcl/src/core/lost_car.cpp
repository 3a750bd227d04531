#include "lost_car.h"

#include <cmath>
#include <utility>

namespace amcl
{
namespace
{
constexpr double kLookInterval = 1.0;  // m between looks
constexpr int kMostLooks = 40;
// A place is e times less likely if its fit is by so much worse: fits err by 0.01.
constexpr double kFitScale = 0.005;
// Places this near to each other are one: the particles find out the rest.
constexpr double kOnePlace = 1.0;    // m
constexpr double kOneHeading = 0.5;  // rad
constexpr double kCertain = 0.99;    // share of what is likely

/// Shares in the place of fits.
void weigh(std::vector<Place> & places)
{
  const double best = places.front().fit;
  double sum = 0.0;
  for (Place & place : places) {
    place.fit = std::exp((place.fit - best) / kFitScale);
    sum += place.fit;
  }
  for (Place & place : places) {
    place.fit /= sum;
  }
}

bool areOne(const std::vector<Place> & places)
{
  const Pose2 & best = places.front().pose;
  double sum = 0.0;
  for (const Place & place : places) {
    const bool is_near =
      distance(place.pose, best) < kOnePlace && std::abs(normalizeAngle(place.pose.yaw - best.yaw)) < kOneHeading;
    sum += is_near ? place.fit : 0.0;
  }
  return sum > kCertain;
}
}  // namespace

LostCar::LostCar(const mrpt::maps::COccupancyGridMap2D & map, Points road) : search_(map), road_(std::move(road)) {}

LostCar::LostCar(const mrpt::maps::COccupancyGridMap2D & map, std::vector<Pose2> poses)
: search_(map), poses_(std::move(poses))
{
}

std::vector<Place> LostCar::look(const mrpt::obs::CObservation2DRangeScan & scan, const Pose2 & odometry)
{
  sight_.add(scan, odometry);
  const bool is_due = !last_ || distance(odometry, *last_) >= kLookInterval;
  const Points seen = is_due ? sight_.points() : Points{};
  if (seen.empty()) {
    return {};
  }
  if (last_) {
    const Pose2 motion = compose(inverse(*last_), odometry);
    for (Pose2 & pose : poses_) {
      pose = compose(pose, motion);
    }
  }
  last_ = odometry;
  ++looks_;
  std::vector<Place> places = road_.empty() ? search_.about(poses_, seen) : search_.everywhere(road_, seen);
  if (!places.empty()) {
    weigh(places);
    is_over_ = areOne(places) || looks_ == kMostLooks;
  }
  return places;
}
}  // namespace amcl
