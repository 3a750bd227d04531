#include "traffic/passing.h"

#include <algorithm>
#include <cmath>

#include "path/plan_parts.h"
#include "path/race_line.h"
#include "traffic/traffic.h"

namespace move_base
{
namespace
{
constexpr double kBeside = 0.15;         // m, wanted between the cars
constexpr double kBesideAtLeast = 0.08;  // m, in the end
constexpr double kApart = 0.1;           // m, before and behind the other within which the car stays beside it
constexpr double kApartTime = 0.06;      // s, the same for each m/s of the car
constexpr double kShadowSearch = 2.5;    // m along the line, in which the other is looked for
constexpr std::size_t kUnmoved = 3;      // at the start of the line, that cannot move

constexpr double kSwerve = 1.0;      // 1/m, of the way to the side at the start of the line
constexpr double kSwervePart = 0.8;  // of the lateral acceleration, that this may take
constexpr double kFallBack = 1.0;    // m/s, slower than the others to get behind them

enum class Side
{
  kLeft,
  kRight
};

// A side on which the car stays, and how fast it drives at most, m/s.
struct Manner
{
  Side side;
  double pace;
};

std::vector<double> speedsOn(const Path & path, const PassingRequest & request, double pace)
{
  std::vector<double> speeds = speedProfile(path, request.costmap, request.limits);
  for (double & speed : speeds) {
    speed = std::min(speed, pace);
  }
  return speeds;
}

// Where an outline is along and beside a line, m.
struct Shadow
{
  Interval along;
  Interval beside;
};

Shadow shadowOn(const Path & line, double near_s, const Box & outline)
{
  const Vec2 middle = outline.middle.position();
  const PathPoint * nearest = &line.front();
  double least = HUGE_VAL;
  for (const PathPoint & point : line) {
    const double away = distance(point.pose.position(), middle);
    if (std::abs(point.s - near_s) < kShadowSearch && away < least) {
      least = away;
      nearest = &point;
    }
  }
  const Pose2 place = compose(inverse(nearest->pose), outline.middle);
  const double c = std::abs(std::cos(place.yaw));
  const double s = std::abs(std::sin(place.yaw));
  const double length = c * outline.half_length + s * outline.half_width;
  const double width = s * outline.half_length + c * outline.half_width;
  return {{nearest->s + place.x - length, nearest->s + place.x + length}, {place.y - width, place.y + width}};
}

class WayPast
{
public:
  WayPast(const PassingRequest & request, const Manner & manner) : request_(request), manner_(manner)
  {
    const Footprint & footprint = request.costmap.footprint();
    const double apart = kApart + kApartTime * request.speed;
    reach_ = {footprint.rear() - apart, footprint.front() + apart};
    swerve_ =
      std::min(kSwerve, kSwervePart * request.limits.max_lateral_acceleration / (request.speed * request.speed));
    until_start_ = (request.request.lead.back().s - request.s) / request.speed;
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
    if (rest.size() < 2) {
      return {};
    }
    const ClearanceRule rule(request_.costmap, rest.front().pose, rest.back().pose, request_.planner.min_obstacle_dist);
    return raceLine(
      rest, request_.costmap, rule,
      {wanted.goal, wanted.race_line->gate_tolerance, wanted.race_line->gate_yaw_tolerance},
      1.0 / request_.planner.min_turning_radius, *wanted.race_line,
      [this](const Path & line, std::vector<Interval> & corridor) { return narrow(line, corridor); });
  }

private:
  bool narrow(const Path & line, std::vector<Interval> & corridor) const
  {
    const std::vector<double> speeds = speedsOn(line, request_, manner_.pace);
    const std::vector<Moment> drive =
      driveAlong(line, speeds, {line.front().s, 0.0, request_.speed}, request_.limits, kForecastTime - until_start_);
    bool way_left = true;
    for (std::size_t k = 0; k < drive.size(); ++k) {
      for (const Forecast & other : request_.others) {
        const Shadow shadow = shadowOn(line, drive[k].s, other.at(until_start_ + drive[k].time));
        if (drive[k].s + reach_.high < shadow.along.low || drive[k].s + reach_.low > shadow.along.high) {
          continue;
        }
        const std::size_t last = k + 1 < drive.size() ? drive[k + 1].index : drive[k].index;
        for (std::size_t i = std::max(kUnmoved, drive[k].index); i <= last; ++i) {
          way_left = keepBeside(shadow.beside, line, i, corridor[i]) && way_left;
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
    const Vec2 left{-std::sin(line[i].pose.yaw), std::cos(line[i].pose.yaw)};
    const double middle = dot(straight_on - line[i].pose.position(), left);
    const double reach = 0.5 * swerve_ * run * run;
    if (manner_.side == Side::kLeft) {
      const bool fits = other.high + half + kBesideAtLeast <= room.high;
      room.low = std::clamp(std::min(other.high + half + kBeside, middle + reach), room.low, room.high);
      return fits;
    }
    const bool fits = other.low - half - kBesideAtLeast >= room.low;
    room.high = std::clamp(std::max(other.low - half - kBeside, middle - reach), room.low, room.high);
    return fits;
  }

  const PassingRequest & request_;
  Manner manner_;
  Interval reach_;      // m, of the car and the distance kept, along it
  double swerve_;       // 1/m
  double until_start_;  // s, until the line begins
};

// How far the car gets, m; nothing if it touches another.
std::optional<double> progressOn(const Plan & plan, const PassingRequest & request, double pace)
{
  const double from = request.s - request.request.lead.front().s;
  const std::vector<Moment> drive = driveAlong(
    plan.path, speedsOn(plan.path, request, pace), {from, 0.0, request.speed}, request.limits, kForecastTime);
  for (const Forecast & other : request.others) {
    if (firstTouch(drive, request.costmap.footprint(), other, kBesideAtLeast)) {
      return std::nullopt;
    }
  }
  return drive.empty() ? 0.0 : drive.back().s;
}

// The line on which the car gets farthest.
std::optional<Plan> planAtPace(const PassingRequest & request, double pace)
{
  std::optional<Plan> best;
  double farthest = 0.0;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Plan plan = request.plan;
    plan.path = WayPast(request, {side, pace}).line();
    if (plan.path.empty()) {
      continue;
    }
    const Path & lead = request.request.lead;
    prepend(lead, plan);
    plan.goal_s = placeOnPath(plan.path, request.request.goal, request.plan.goal_s - lead.front().s);
    const auto progress = progressOn(plan, request, pace);
    if (progress && *progress > farthest) {
      farthest = *progress;
      best = std::move(plan);
    }
  }
  return best;
}
}  // namespace

std::optional<Plan> planPast(const PassingRequest & request)
{
  if (auto past = planAtPace(request, HUGE_VAL)) {
    return past;
  }
  double pace = HUGE_VAL;
  for (const Forecast & other : request.others) {
    pace = std::min(pace, other.speed() - kFallBack);
  }
  return planAtPace(request, std::max(pace, 0.0));
}
}  // namespace move_base
