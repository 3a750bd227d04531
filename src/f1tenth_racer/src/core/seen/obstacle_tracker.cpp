#include "seen/obstacle_tracker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace f1tenth_racer
{
namespace
{
constexpr double kGap = 0.25;           // m, between hits of the same obstacle at most
constexpr std::size_t kFewestHits = 2;  // of an obstacle
constexpr double kLargest = 1.5;        // m; what is larger is no car
constexpr double kSameObstacle = 0.5;   // m, from where it was expected
constexpr double kSightMemory = 0.25;   // s, over which a velocity is taken, and for which what is out of sight counts
constexpr double kShortestSight = 0.095;  // s, of a velocity
constexpr double kTrailMemory = 2.0;      // s
constexpr double kTrailStep = 0.1;        // s
constexpr double kLeastWay = 0.5;         // m, of what has driven about, before it stopped: less is an error
constexpr double kStartsMoving = 0.4;     // m/s
constexpr double kStopsMoving = 0.2;      // m/s
// Dimensions of a car, of which the lidar sees only one or two sides, or what sticks out on top.
constexpr double kLeastLength = 0.58;  // m
constexpr double kLeastWidth = 0.31;   // m
constexpr double kLargestTop = 0.2;    // m, of what may be the lidar of a low car
constexpr double kTopToBumper = 0.4;   // m, from the middle of that to the farther end of the car
constexpr double kSwing = 0.05;   // m, by which its ends are off the way of its top in a bend, or once it has turned
constexpr double kInside = 0.04;  // m, behind what is hit of it

double slower(double a, double b)
{
  if (a * b <= 0.0) {
    return 0.0;
  }
  return std::abs(a) < std::abs(b) ? a : b;
}

// Makes an interval at least so long, away from where it is seen from.
Interval completed(const Interval & seen, double least, double viewer)
{
  const double missing = std::max(0.0, least - (seen.high - seen.low));
  if (viewer < seen.low) {
    return {seen.low, seen.high + missing};
  }
  return viewer > seen.high ? Interval{seen.low - missing, seen.high}
                            : Interval{seen.low - 0.5 * missing, seen.high + 0.5 * missing};
}

Interval around(const Interval & seen, double half)
{
  const double middle = 0.5 * (seen.low + seen.high);
  return {middle - half, middle + half};
}
}  // namespace

void ObstacleTracker::observe(double time, const Vec2 & sensor, const std::vector<Vec2> & hits)
{
  if (time <= last_time_) {
    tracks_.clear();
    begin_.reset();
    has_driven_ = false;
  }
  last_time_ = time;
  begin_ = begin_.value_or(sensor);
  has_driven_ = has_driven_ || distance(*begin_, sensor) > kLeastWay;
  assign(time, clustersOf(hits));
  forgetLost(time);
  moving_.clear();
  stopped_.clear();
  for (Track & track : tracks_) {
    if (track.moves()) {
      track.noteTrail(sensor);
      moving_.push_back(track.obstacle(sensor));
    } else if (track.hasDriven() || (has_driven_ && track.mayBeTop())) {
      stopped_.push_back(track.stopped(sensor));
    }
  }
}

void ObstacleTracker::forgetLost(double time)
{
  const auto lost = [time](const Track & track) { return track.lastSeen() < time - kSightMemory; };
  glimpses_.clear();
  for (const Track & track : tracks_) {
    if (lost(track) && !track.decided()) {
      glimpses_.push_back(track.extent());
    }
  }
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), lost), tracks_.end());
}

std::vector<ObstacleTracker::Cluster> ObstacleTracker::clustersOf(const std::vector<Vec2> & hits)
{
  std::vector<Cluster> clusters;
  for (const Vec2 & hit : hits) {
    if (clusters.empty() || distance(clusters.back().back(), hit) > kGap) {
      clusters.emplace_back();
    }
    clusters.back().push_back(hit);
  }
  const auto no_car = [](const Cluster & cluster) {
    return cluster.size() < kFewestHits || distance(cluster.front(), cluster.back()) > kLargest;
  };
  clusters.erase(std::remove_if(clusters.begin(), clusters.end(), no_car), clusters.end());
  return clusters;
}

void ObstacleTracker::assign(double time, std::vector<Cluster> clusters)
{
  const std::size_t known = tracks_.size();
  for (Cluster & cluster : clusters) {
    Vec2 middle;
    for (const Vec2 & hit : cluster) {
      middle = middle + (1.0 / static_cast<double>(cluster.size())) * hit;
    }
    std::size_t best = known;
    double nearest = kSameObstacle;
    for (std::size_t i = 0; i < known; ++i) {
      const double away = distance(tracks_[i].expected(time), middle);
      if (tracks_[i].lastSeen() < time && away < nearest) {
        best = i;
        nearest = away;
      }
    }
    if (best < known) {
      tracks_[best].see(time, std::move(cluster));
    } else {
      tracks_.emplace_back(time, std::move(cluster));
    }
  }
}

Vec2 ObstacleTracker::Track::expected(double time) const
{
  const Sighting & last = sightings_.back();
  return 0.5 * (last.low + last.high) + (time - last.time) * velocity_;
}

Box ObstacleTracker::Track::extent() const
{
  Vec2 low = sightings_.front().low;
  Vec2 high = sightings_.front().high;
  for (const Sighting & each : sightings_) {
    low = {std::min(low.x, each.low.x), std::min(low.y, each.low.y)};
    high = {std::max(high.x, each.high.x), std::max(high.y, each.high.y)};
  }
  const Vec2 middle = 0.5 * (low + high);
  return {{middle.x, middle.y, 0.0}, 0.5 * (high.x - low.x), 0.5 * (high.y - low.y)};
}

void ObstacleTracker::Track::see(double time, Cluster hits)
{
  hits_ = std::move(hits);
  const auto x = std::minmax_element(hits_.begin(), hits_.end(), [](auto & a, auto & b) { return a.x < b.x; });
  const auto y = std::minmax_element(hits_.begin(), hits_.end(), [](auto & a, auto & b) { return a.y < b.y; });
  sightings_.push_back({time, {x.first->x, y.first->y}, {x.second->x, y.second->y}});
  while (sightings_.front().time < time - kSightMemory) {
    sightings_.pop_front();
  }
  estimateVelocity();
}

void ObstacleTracker::Track::estimateVelocity()
{
  if (lastSeen() - sightings_.front().time < kShortestSight) {
    return;
  }
  decided_ = true;
  // The slope of the straight line through what is measured over time, by least squares.
  const auto slope = [this](const std::function<double(const Sighting &)> & measured) {
    double mean_time = 0.0;
    for (const Sighting & each : sightings_) {
      mean_time += each.time / static_cast<double>(sightings_.size());
    }
    double rise = 0.0;
    double run = 0.0;
    for (const Sighting & each : sightings_) {
      const double away = each.time - mean_time;
      rise += away * measured(each);
      run += away * away;
    }
    return rise / run;
  };
  velocity_ = {
    slower(slope([](auto & s) { return s.low.x; }), slope([](auto & s) { return s.high.x; })),
    slower(slope([](auto & s) { return s.low.y; }), slope([](auto & s) { return s.high.y; }))};
  if (norm(velocity_) > (moves() ? kStopsMoving : kStartsMoving)) {
    last_moved_ = lastSeen();
    heading_ = maths::atan2(velocity_.y, velocity_.x);
  }
}

bool ObstacleTracker::Track::hasDriven() const
{
  return !trail_.empty() && distance(trail_.front().pose, trail_.back().pose) > kLeastWay;
}

bool ObstacleTracker::Track::mayBeTop() const
{
  const Box seen = extent();
  return decided_ && !last_moved_ && 2.0 * std::max(seen.half_length, seen.half_width) < kLargestTop;
}

void ObstacleTracker::Track::noteTrail(const Vec2 & sensor)
{
  if (last_moved_ != lastSeen() || (!trail_.empty() && lastSeen() <= trail_.back().time + kTrailStep)) {
    return;
  }
  trail_.push_back({lastSeen(), outline(sensor).middle});
  while (trail_.front().time < lastSeen() - kTrailMemory) {
    trail_.pop_front();
  }
}

Box ObstacleTracker::Track::outline(const Vec2 & sensor) const
{
  const Pose2 frame = inverse({0.0, 0.0, heading_});
  Interval along{HUGE_VAL, -HUGE_VAL};
  Interval across{HUGE_VAL, -HUGE_VAL};
  for (const Vec2 & hit : hits_) {
    const Vec2 turned = transform(frame, hit);
    along = {std::min(along.low, turned.x), std::max(along.high, turned.x)};
    across = {std::min(across.low, turned.y), std::max(across.high, turned.y)};
  }
  if (std::max(along.high - along.low, across.high - across.low) < kLargestTop) {
    along = around(along, kTopToBumper);
    across = around(across, 0.5 * kLeastWidth + kSwing);
  } else {
    const Vec2 viewer = transform(frame, sensor);
    along = completed(along, kLeastLength, viewer.x);
    across = completed(across, kLeastWidth, viewer.y);
  }
  const Vec2 middle =
    transform({0.0, 0.0, heading_}, {0.5 * (along.low + along.high), 0.5 * (across.low + across.high)});
  return {{middle.x, middle.y, heading_}, 0.5 * (along.high - along.low), 0.5 * (across.high - across.low)};
}

StoppedObstacle ObstacleTracker::Track::stopped(const Vec2 & sensor) const
{
  const Vec2 & middle = hits_[hits_.size() / 2];
  const Vec2 inside = middle + (kInside / distance(sensor, middle)) * (middle - sensor);
  if (hasDriven()) {
    return {grown(outline(sensor), kSwing), inside};
  }
  return {{{inside.x, inside.y, 0.0}, kTopToBumper, 0.5 * kLeastWidth + kSwing}, inside, false};
}
}  // namespace f1tenth_racer
