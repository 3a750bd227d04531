#include "traffic/passing.h"

#include <algorithm>
#include <cmath>

#include "line/race_line.h"
#include "path/goals.h"
#include "traffic/traffic.h"

namespace f1tenth_racer
{
namespace
{
constexpr double kBesideAtLeast = 0.08;  // m, in the end
constexpr double kApart = 0.1;           // m, ahead of and behind the other within which the car stays beside it
constexpr double kApartTime = 0.06;      // s, the same for each m/s of the car

constexpr double kSwerve = 1.0;      // 1/m, curvature of the way to the side at the start of the line
constexpr double kSwervePart = 0.8;  // of the lateral acceleration, that this may take
constexpr double kFallBack = 1.0;    // m/s, slower than the others to get behind them
constexpr double kSwingWay = 1.0;    // m, behind another until the car is to the side of it
constexpr double kFallTime = 1.5;    // s, until it is behind them
constexpr double kLeastPace = 0.5;   // m/s, of either

enum class Side
{
  kLeft,
  kRight
};

// How the car drives: at most at a pace, m/s, for some way, m, and past the goal within a distance, m.
struct Manner
{
  double pace;
  double way;
  double gate;
};

Caution cautionOf(const PassingRequest & request, const Manner & manner, double s)
{
  return {request.traffic.passing_lateral_part, manner.pace, s + manner.way};
}

// Along the plan's path until a line begins that leads past others, m.
double wayToStart(const PassingRequest & request)
{
  return request.request.lead.back().s - request.s;
}

class WayPast
{
public:
  WayPast(const PassingRequest & request, const Manner & manner, Side side)
  : request_(request), manner_(manner), side_(side)
  {
    const Footprint & footprint = request.costmap.footprint();
    const double apart = kApart + kApartTime * request.car.speed;
    reach_ = {footprint.rear() - apart, footprint.front() + apart};
    const double lateral = kSwervePart * request.traffic.passing_lateral_part * request.limits.max_lateral_acceleration;
    swerve_ = std::min(kSwerve, lateral / (request.car.speed * request.car.speed));
    way_to_start_ = wayToStart(request);
    until_start_ = way_to_start_ / request.car.speed;
  }

  Path line() const
  {
    const PlanRequest & wanted = request_.request;
    Path rest;
    for (const PathPoint & point : request_.plan.path) {
      if (point.s >= wanted.lead.back().s) {
        rest.push_back(point);
      }
    }
    if (rest.size() < 2 || !isForward(rest)) {
      return {};
    }
    RaceLineOptions options = *wanted.race_line;
    options.gate_tolerance = manner_.gate;
    return raceLine(
      rest, request_.costmap, request_.planner.min_obstacle_dist, wanted.goal,
      1.0 / request_.planner.min_turning_radius, options,
      [this](const Path & line, std::vector<Interval> & corridor) { return narrow(line, corridor); });
  }

private:
  bool narrow(const Path & line, std::vector<Interval> & corridor) const
  {
    const std::vector<double> speeds = speedProfile(
      line, request_.costmap, request_.limits, cautionOf(request_, manner_, line.front().s - way_to_start_));
    const std::vector<Moment> drive = driveAlong(
      line, speeds, {line.front().s, 0.0, request_.car.speed}, request_.limits, kForecastTime - until_start_);
    bool way_left = true;
    for (std::size_t k = 0; k < drive.size(); ++k) {
      const std::size_t last = k + 1 < drive.size() ? drive[k + 1].index : drive[k].index;
      for (const Forecast & other : request_.others) {
        const Box outline = other.at(until_start_ + drive[k].time);
        for (std::size_t i = std::max(kFixedPoints, drive[k].index); i <= last; ++i) {
          const Extent extent = extentOf(outline, line[i].pose);
          if (reach_.high >= extent.along.low && reach_.low <= extent.along.high) {
            way_left = keepBeside(extent.beside, line, i, corridor[i]) && way_left;
          }
        }
      }
    }
    return way_left;
  }

  // As far beside the other as wanted, or as there is room; at the start as far as the car gets.
  bool keepBeside(const Interval & other, const Path & line, std::size_t i, Interval & room) const
  {
    const double half = request_.costmap.footprint().halfWidth();
    const double run = line[i].s - line.front().s;
    const Vec2 straight_on = advance(line.front().pose, run, line.front().curvature).position();
    const Vec2 left = leftNormal(line[i].pose);
    const double middle = dot(straight_on - line[i].pose.position(), left);
    const double reach = 0.5 * swerve_ * run * run;
    if (side_ == Side::kLeft) {
      const bool fits = other.high + half + kBesideAtLeast <= room.high;
      room.low = std::clamp(
        std::min(other.high + half + request_.traffic.passing_distance, middle + reach), room.low, room.high);
      return fits;
    }
    const bool fits = other.low - half - kBesideAtLeast >= room.low;
    room.high =
      std::clamp(std::max(other.low - half - request_.traffic.passing_distance, middle - reach), room.low, room.high);
    return fits;
  }

  const PassingRequest & request_;
  Manner manner_;
  Side side_;
  Interval reach_;       // m, of the car and the distance kept, along it
  double swerve_;        // 1/m
  double way_to_start_;  // m, until the line begins
  double until_start_;   // s, the same
};

// How far the car gets, m; nothing if it touches another.
std::optional<double> progressOn(const PassingPlan & past, const PassingRequest & request)
{
  const Path & path = past.plan.path;
  const double from = request.s - request.request.lead.front().s;
  const std::vector<double> speeds = speedProfile(path, request.costmap, request.limits, past.caution);
  const std::vector<Moment> drive =
    driveAlong(path, speeds, {from, 0.0, request.car.speed}, request.limits, kForecastTime);
  for (const Forecast & other : request.others) {
    if (firstTouch(drive, request.costmap.footprint(), other, kBesideAtLeast)) {
      return std::nullopt;
    }
  }
  return drive.empty() ? 0.0 : drive.back().s;
}

// The line on which the car gets farthest.
std::optional<PassingPlan> planIn(const PassingRequest & request, const Manner & manner)
{
  std::optional<PassingPlan> best;
  double farthest = 0.0;
  const Path & lead = request.request.lead;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    PassingPlan past{request.plan, cautionOf(request, manner, request.s - lead.front().s)};
    past.plan.path = WayPast(request, manner, side).line();
    if (past.plan.path.empty()) {
      continue;
    }
    prepend(lead, past.plan);
    past.plan.goal_s = placeOnPath(past.plan.path, request.request.goal, request.plan.goal_s - lead.front().s);
    const auto progress = progressOn(past, request);
    if (progress && *progress > farthest) {
      farthest = *progress;
      best = std::move(past);
    }
  }
  return best;
}
}  // namespace

std::optional<PassingPlan> planPast(const PassingRequest & request)
{
  const Footprint & footprint = request.costmap.footprint();
  const double gate = request.request.race_line->gate_tolerance;
  if (auto past = planIn(request, {HUGE_VAL, 0.0, gate})) {
    return past;
  }
  double behind = HUGE_VAL;  // m/s, of those ahead
  double beside = HUGE_VAL;
  for (const Forecast & other : request.others) {
    double & pace = isBeside(other.at(0.0), request.car.pose, footprint) ? beside : behind;
    pace = std::min(pace, other.speed());
  }
  const double way_to_start = wayToStart(request);
  if (!std::isfinite(beside)) {
    return planIn(request, {std::max(behind, kLeastPace), way_to_start + kSwingWay, gate});
  }
  const double pace = std::max(beside - kFallBack, kLeastPace);
  const double way = way_to_start + pace * kFallTime;
  for (const Manner & manner :
       {Manner{pace, way, gate}, Manner{HUGE_VAL, 0.0, HUGE_VAL}, Manner{pace, way, HUGE_VAL}}) {
    if (auto past = planIn(request, manner)) {
      return past;
    }
  }
  return std::nullopt;
}
}  // namespace f1tenth_racer
