#include "place_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace amcl
{
namespace
{
// Places that are checked first are this far from each other. Walls then count as hit if they are as near as a car
// between two such places sees them.
constexpr double kStep = 0.2;  // m
constexpr int kHeadings = 120;
constexpr double kSlack = 0.15;     // m
constexpr double kDeviation = 0.1;  // m, of the map and of what was seen
constexpr double kLeastFit = 0.7;
constexpr std::size_t kFewPoints = 40;
constexpr std::size_t kPoints = 100;
constexpr std::size_t kManyPoints = 300;
// This many of the places are checked more closely.
constexpr std::size_t kGood = 20000;
constexpr std::size_t kBetter = 300;
constexpr std::size_t kFinalists = 40;  // with all points: the better of two that are alike must not win by chance
// Of places nearer to each other than about this only the best one counts.
constexpr double kApart = 0.3;       // m
constexpr double kTurnApart = 0.15;  // rad
// The search for the best place about one begins with these steps, ...
constexpr Steps kSteps{0.1, 0.026, 100};
// ... and where odometry tells where the car was some metres before, with these: on a straight there is always a better
// place a little farther on.
constexpr Steps kFewSteps{0.05, 0.013, 4};
constexpr int kHalvings = 4;

void keepBest(std::vector<Place> & places, std::size_t count)
{
  std::stable_sort(places.begin(), places.end(), [](const Place & a, const Place & b) { return a.fit > b.fit; });
  places.resize(std::min(places.size(), count));
}

Points someOf(const Points & points, std::size_t count)
{
  Points some;
  some.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(points[i * points.size() / count]);
  }
  return some;
}
}  // namespace

void keepPeaks(std::vector<Place> & places, std::size_t count)
{
  keepBest(places, places.size());
  std::set<std::array<long, 3>> taken;
  std::vector<Place> peaks;
  for (const Place & place : places) {
    const std::array bin{
      std::lround(place.pose.x / kApart), std::lround(place.pose.y / kApart),
      std::lround(normalizeAngle(place.pose.yaw) / kTurnApart)};
    if (peaks.size() < count && taken.insert(bin).second) {
      peaks.push_back(place);
    }
  }
  places = std::move(peaks);
}

PlaceSearch::PlaceSearch(const mrpt::maps::COccupancyGridMap2D & map)
: cell_(map.getResolution()),
  field_(map),
  coarse_(kSlack, kDeviation),
  middle_(0.0, 2.0 * kDeviation),
  fine_(0.0, kDeviation)
{
}

std::vector<Place> PlaceSearch::everywhere(const Points & road, const Points & seen) const
{
  const Points few = someOf(seen, kFewPoints);
  double least = kLeastFit;
  const long stride = std::max(1L, std::lround(kStep / cell_));
  std::vector<Place> places;
  for (const auto & cell : road) {
    if (std::lround(cell.x / cell_ - 0.5) % stride != 0 || std::lround(cell.y / cell_ - 0.5) % stride != 0) {
      continue;
    }
    for (int i = 0; i < kHeadings; ++i) {
      const Pose2 pose{cell.x, cell.y, 2.0 * M_PI * i / kHeadings - M_PI};
      if (const double fit = field_.rough(coarse_, few, pose, least); fit > least) {
        places.push_back({pose, fit});
      }
    }
    if (places.size() > 2 * kGood) {  // what is no longer among the best is given up early
      keepBest(places, kGood);
      least = places.back().fit;
    }
  }
  return settle(std::move(places), seen);
}

std::vector<Place> PlaceSearch::about(const std::vector<Pose2> & poses, const Points & seen) const
{
  std::vector<Place> places;
  places.reserve(poses.size());
  for (const auto & pose : poses) {
    places.push_back({pose, 0.0});
  }
  return settle(std::move(places), seen);
}

Place PlaceSearch::near(const Pose2 & pose, const Points & seen) const
{
  Place place{pose, 0.0};
  climb(someOf(seen, kPoints), place, kFewSteps);
  place.fit = field_.close(fine_, someOf(seen, kManyPoints), place.pose);
  return place;
}

/// Moves a place to the nearest one about which none is better.
void PlaceSearch::climb(const Points & seen, Place & place, Steps steps) const
{
  place.fit = field_.close(fine_, seen, place.pose);
  auto [step, turn, rounds] = steps;
  for (int halvings = 0; halvings < kHalvings && rounds > 0; --rounds) {
    Place best = place;
    for (int i = 0; i < 27; ++i) {
      const int steps_x = i % 3 - 1;
      const int steps_y = i / 3 % 3 - 1;
      const int turns = i / 9 - 1;
      const Pose2 next{place.pose.x + steps_x * step, place.pose.y + steps_y * step, place.pose.yaw + turns * turn};
      const double fit = field_.close(fine_, seen, next, best.fit);
      best = fit > best.fit ? Place{next, fit} : best;
    }
    if (best.fit > place.fit) {
      place = best;
    } else {
      ++halvings;
      step /= 2.0;
      turn /= 2.0;
    }
  }
}

std::vector<Place> PlaceSearch::settle(std::vector<Place> places, const Points & seen) const
{
  keepBest(places, kGood);
  const Points some = someOf(seen, kPoints);
  for (Place & place : places) {
    place.fit = field_.rough(middle_, some, place.pose);
  }
  keepPeaks(places, kBetter);
  const Points many = someOf(seen, kManyPoints);
  for (Place & place : places) {
    climb(some, place, kSteps);
    place.fit = field_.close(fine_, many, place.pose);
  }
  keepPeaks(places, kBetter);
  std::for_each(places.begin(), places.begin() + std::min(places.size(), kFinalists), [&](Place & place) {
    climb(many, place, kSteps);
  });
  keepPeaks(places, kBetter);
  return places;
}
}  // namespace amcl
