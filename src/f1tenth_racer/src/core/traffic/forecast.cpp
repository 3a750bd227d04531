#include "traffic/forecast.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seen/lookout.h"

namespace f1tenth_racer
{
namespace
{
constexpr double kForecastStep = 0.1;    // s
constexpr double kWallTolerance = 0.05;  // m, by which it may come nearer to a wall
constexpr double kStrays = 0.3;          // m, of unrest
constexpr double kTrust = 1.05;          // s, over which forecasts from the past are compared with what happened
// 1/m, from the straight line to what a car can steer.
constexpr std::array<double, 15> kCurvatures{0.0,   0.1, -0.1, 0.2, -0.2, 0.3,  -0.3, 0.45,
                                             -0.45, 0.6, -0.6, 0.9, -0.9, 1.25, -1.25};

// The straightest way that keeps the distance from walls, or else the one that keeps the most.
double curvatureOfRoad(const Pose2 & from, double wanted, const Costmap & costmap)
{
  double best = 0.0;
  double most = -HUGE_VAL;
  for (const double curvature : kCurvatures) {
    const double room = std::min(roomAlong(costmap, from, curvature), wanted);
    if (room > most) {
      best = curvature;
      most = room;
    }
    if (most >= wanted) {
      break;
    }
  }
  return best;
}

// How far beside the forecast of then it has been since, m; how fast it was does not matter.
Interval unrestOf(const MovingObstacle & obstacle, const Costmap & costmap)
{
  Interval unrest{0.0, 0.0};
  const std::deque<Sight> & trail = obstacle.trail;
  for (std::size_t then = 0; then < trail.size(); ++then) {
    Pose2 forecast = trail[then].pose;
    const double room = costmap.wallDistance(forecast.position()) - kWallTolerance;
    for (std::size_t i = then + 1; i < trail.size() && trail[i].time < trail[then].time + kTrust; ++i) {
      const double way = distance(trail[i - 1].pose, trail[i].pose);
      forecast = advance(forecast, way, curvatureOfRoad(forecast, room, costmap));
      const double beside = compose(inverse(forecast), trail[i].pose).y;
      unrest = {std::min(unrest.low, beside), std::max(unrest.high, beside)};
    }
  }
  return unrest;
}
}  // namespace

Forecast::Forecast(const MovingObstacle & obstacle, const Costmap & costmap, double now) : speed_(obstacle.speed)
{
  Box outline = obstacle.outline;
  const double room = costmap.wallDistance(outline.middle.position()) - kWallTolerance;
  const auto drive = [&](double time) {
    outline.middle = advance(outline.middle, speed_ * time, curvatureOfRoad(outline.middle, room, costmap));
  };
  drive(std::max(0.0, now - obstacle.seen));
  outlines_.push_back(outline);
  for (double time = kForecastStep; time < kForecastTime + 0.5 * kForecastStep; time += kForecastStep) {
    drive(kForecastStep);
    outlines_.push_back(outline);
  }
  unrest_ = unrestOf(obstacle, costmap);
}

Forecast Forecast::braking(double deceleration) const
{
  Forecast result = *this;
  result.deceleration_ = deceleration;
  return result;
}

Forecast Forecast::anywhere() const
{
  Forecast result = *this;
  const double most = std::max(-unrest_.low, unrest_.high);
  result.unrest_ = {-most, most};
  result.is_anywhere_ = true;
  return result;
}

bool Forecast::strays() const
{
  return unrest_.high - unrest_.low > kStrays;
}

double Forecast::wayToStand(double time) const
{
  const double speed = std::max(0.0, speed_ - deceleration_ * time);
  return deceleration_ > 0.0 ? 0.5 * speed * speed / deceleration_ : 0.0;
}

// An obstacle that brakes gets to each place later.
Box Forecast::at(double time) const
{
  const bool brakes = deceleration_ > 0.0 && speed_ > 0.0;
  const double driven = brakes ? (wayToStand(0.0) - wayToStand(time)) / speed_ : time;
  const double index = std::clamp(driven / kForecastStep, 0.0, static_cast<double>(outlines_.size() - 1));
  const auto before = static_cast<std::size_t>(index);
  const Box & a = outlines_[before];
  const Box & b = outlines_[std::min(before + 1, outlines_.size() - 1)];
  const double part = index - static_cast<double>(before);
  Box result = a;
  result.middle = between(a.middle, b.middle, part);
  const double doubt = is_anywhere_ ? 1.0 : std::min(1.0, time / kTrust);
  result.middle = compose(result.middle, {0.0, 0.5 * doubt * (unrest_.low + unrest_.high), 0.0});
  result.half_width += 0.5 * doubt * (unrest_.high - unrest_.low);
  return result;
}
}  // namespace f1tenth_racer
