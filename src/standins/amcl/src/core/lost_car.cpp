#include "lost_car.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace amcl
{
namespace
{
constexpr double kLookInterval = 1.0;  // m between looks
constexpr std::size_t kMostLooks = 40;
constexpr std::size_t kLooksApart = 4;  // this many looks apart, two have seen different parts of the way
// A place is e times less likely if its fit is worse by this much: fits err by 0.01.
constexpr double kFitScale = 0.005;
constexpr double kFarWorse = 10.0 * kFitScale;  // whatever was seen before
constexpr std::size_t kKept = 300;
// Places this near to each other are one: the particles find out the rest.
constexpr double kOnePlace = 1.0;    // m
constexpr double kOneHeading = 0.5;  // rad
constexpr double kCertain = 0.99;    // share of what is likely

/// Replaces fits by shares.
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
  const bool is_due = looks_.empty() || distance(odometry, looks_.back().odometry) >= kLookInterval;
  const Points seen = is_due ? sight_.points() : Points{};
  if (seen.empty()) {
    return {};
  }
  if (!looks_.empty()) {
    const Pose2 motion = compose(inverse(looks_.back().odometry), odometry);
    for (Pose2 & pose : poses_) {
      pose = compose(pose, motion);
    }
  }
  looks_.push_back({odometry, seen});
  std::vector<Place> places = find();
  if (places.empty()) {
    return places;
  }
  weigh(places);
  poses_.clear();
  for (const Place & place : places) {
    poses_.push_back(place.pose);
  }
  certain_ = areOne(places) ? certain_ + 1 : 0;
  is_over_ = certain_ > kLooksApart || looks_.size() == kMostLooks;
  return places;
}

std::vector<Place> LostCar::find() const
{
  const Points & seen = looks_.back().seen;
  std::vector<Place> places = search_.about(poses_, seen);
  if (!road_.empty()) {
    const std::vector<Place> others = search_.everywhere(road_, seen);
    places.insert(places.end(), others.begin(), others.end());
  }
  keepPeaks(places, kKept);
  const auto is_far_worse = [&](const Place & place) { return place.fit < places.front().fit - kFarWorse; };
  places.erase(std::find_if(places.begin(), places.end(), is_far_worse), places.end());
  remember(places);
  return places;
}

/// Adds how well what was seen earlier fits, if the car came from where odometry says, or next to it. Best first.
void LostCar::remember(std::vector<Place> & places) const
{
  for (Place & place : places) {
    Pose2 pose = place.pose;
    for (std::size_t i = looks_.size() - 1; i >= kLooksApart;) {
      const Pose2 & odometry = looks_[i].odometry;
      i -= kLooksApart;
      const Place before = search_.near(compose(pose, compose(inverse(odometry), looks_[i].odometry)), looks_[i].seen);
      place.fit += before.fit;
      pose = before.pose;
    }
  }
  keepPeaks(places, kKept);
}
}  // namespace amcl
