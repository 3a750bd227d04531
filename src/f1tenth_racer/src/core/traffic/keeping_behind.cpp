#include "traffic/keeping_behind.h"

#include <algorithm>

namespace f1tenth_racer
{
namespace
{
constexpr double kTrafficTime = 2.5;     // s, for which others ahead count
constexpr double kTrafficMargin = 0.06;  // m, beside them: what forecasts are wrong by
constexpr double kClosingLag = 0.15;     // s, by which a car's speed and what is known of the other's lag behind
constexpr double kFallBehind = 1.0;      // m/s slower than the other, when it is too near already
constexpr double kApproachRate = 2.5;    // 1/s, of the last metre to it

// The others that the car would touch on its way.
std::vector<Touch> touches(const OwnWay & way, const std::vector<Forecast> & others)
{
  if (others.empty()) {
    return {};
  }
  const std::vector<Moment> drive = driveAlong(way.path, way.speeds, way.departure, way.limits, kTrafficTime);
  std::vector<Touch> all;
  for (const Forecast & other : others) {
    if (const auto touch = firstTouch(drive, way.footprint, other, kTrafficMargin)) {
      all.push_back(*touch);
    }
  }
  return all;
}

std::vector<Forecast> allBraking(const std::vector<Forecast> & others, double deceleration)
{
  std::vector<Forecast> braking;
  braking.reserve(others.size());
  for (const Forecast & other : others) {
    braking.push_back(other.braking(deceleration));
  }
  return braking;
}

// The lowest speeds that those ahead allow.
SpeedBehind leastBehind(const OwnWay & way, const std::vector<Forecast> & others)
{
  const double speed = way.departure.speed;
  SpeedBehind least;
  for (const Touch & touch : touches(way, others)) {
    if (touch.ahead) {
      const SpeedBehind behind = speedBehind(touch, speed, way.limits.deceleration(speed), way.traffic);
      least = {std::min(least.wanted, behind.wanted), std::min(least.utmost, behind.utmost)};
    }
  }
  return least;
}
}  // namespace

bool isHindered(const OwnWay & way, const std::vector<Forecast> & others)
{
  const std::vector<Touch> all = touches(way, others);
  return std::any_of(all.begin(), all.end(), [](const Touch & touch) { return !touch.behind; });
}

SpeedBehind speedBehind(const Touch & touch, double speed, double deceleration, const TrafficOptions & traffic)
{
  const double closing = std::max(0.0, speed - touch.speed);
  const double gap = touch.way - touch.speed * touch.time - closing * kClosingLag;
  const auto braking = [&](double way) {
    return std::sqrt(touch.speed * touch.speed + 2.0 * deceleration * std::max(0.0, way));
  };
  const double spare = gap - traffic.follow_distance - traffic.follow_time * touch.speed;
  return {
    std::max(0.0, std::min(braking(spare), touch.speed + kApproachRate * spare)),
    gap > 0.0 ? braking(gap) : std::max(0.0, touch.speed - kFallBehind)};
}

SpeedBehind speedBehindOthers(const OwnWay & way, const std::vector<Forecast> & others)
{
  const SpeedBehind as_they_drive = leastBehind(way, others);
  const SpeedBehind if_they_brake = leastBehind(way, allBraking(others, way.traffic.others_braking));
  return {as_they_drive.wanted, std::min(as_they_drive.utmost, if_they_brake.utmost)};
}
}  // namespace f1tenth_racer
