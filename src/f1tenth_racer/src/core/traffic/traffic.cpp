#include "traffic/traffic.h"

#include <workspace_support/maths/exponential.h>

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kDriveStep = 0.05;    // s
constexpr double kResponse = 0.1;      // s, until the speed begins to change
constexpr double kOffsetLength = 0.8;  // m, over which a car comes back to its path

Pose2 poseAt(const Path & path, std::size_t index, double s)
{
  const PathPoint & a = path[index];
  const PathPoint & b = path[std::min(index + 1, path.size() - 1)];
  return between(a.pose, b.pose, b.s > a.s ? std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0) : 0.0);
}

// Whether all of another is ahead of a car.
bool isAhead(const Box & other, const Pose2 & car, const Footprint & footprint)
{
  return extentOf(other, car).along.low >= footprint.front();
}
}  // namespace

Extent extentOf(const Box & outline, const Pose2 & from)
{
  const Pose2 place = compose(inverse(from), outline.middle);
  const double c = std::abs(maths::cos(place.yaw));
  const double s = std::abs(maths::sin(place.yaw));
  const double length = c * outline.half_length + s * outline.half_width;
  const double width = s * outline.half_length + c * outline.half_width;
  return {{place.x - length, place.x + length}, {place.y - width, place.y + width}};
}

bool isBeside(const Box & other, const Pose2 & car, const Footprint & footprint)
{
  const Extent extent = extentOf(other, car);
  return extent.along.low < footprint.front() && extent.along.high > footprint.rear();
}

Forecast seenFrom(const Pose2 & car, const Footprint & footprint, const Forecast & other)
{
  const bool is_unsure = isAhead(other.at(0.0), car, footprint) && other.strays();
  return is_unsure ? other.anywhere() : other;
}

std::vector<Forecast> forecasts(
  const std::vector<MovingObstacle> & moving, const Costmap & costmap, double now, const Pose2 & car)
{
  std::vector<Forecast> result;
  for (const MovingObstacle & obstacle : moving) {
    result.push_back(seenFrom(car, costmap.footprint(), Forecast(obstacle, costmap, now)));
  }
  return result;
}

std::vector<Moment> driveAlong(
  const Path & path, const std::vector<double> & speeds, const Departure & departure, const SpeedLimits & limits,
  double horizon)
{
  std::vector<Moment> drive;
  double speed = departure.speed;
  double s = departure.s;
  std::size_t index = 0;
  for (double time = 0.0; time < horizon && s < path.back().s; time += kDriveStep) {
    while (index + 2 < path.size() && path[index + 1].s <= s) {
      ++index;
    }
    const double offset = departure.lateral * maths::exp(-(s - departure.s) / kOffsetLength);
    Pose2 pose = poseAt(path, index, s);
    pose.x -= offset * maths::sin(pose.yaw);
    pose.y += offset * maths::cos(pose.yaw);
    drive.push_back({time, s, index, pose});
    const double wanted = std::max(std::min(speeds[index], speeds[index + 1]), limits.min_vel_x);
    if (time >= kResponse) {
      speed =
        std::clamp(wanted, speed - limits.deceleration(speed) * kDriveStep, speed + limits.acc_lim_x * kDriveStep);
    }
    s += std::max(speed, 0.0) * kDriveStep;
  }
  return drive;
}

std::optional<Touch> firstTouch(
  const std::vector<Moment> & drive, const Footprint & footprint, const Forecast & other, double margin)
{
  constexpr double kNoise = 0.01;  // m
  double allowed = margin;
  for (const Moment & moment : drive) {
    const Box outline = other.at(moment.time);
    const double away = clearance(outline, footprint, moment.pose);
    if (moment.time == 0.0) {
      allowed = std::min(margin, away - kNoise);
    } else if (away < allowed) {
      const double along = maths::cos(normalizeAngle(outline.middle.yaw - moment.pose.yaw));
      const double place = transform(inverse(moment.pose), outline.middle.position()).x;
      const bool ahead =
        place > 0.5 * (footprint.rear() + footprint.front()) || isAhead(other.at(0.0), drive.front().pose, footprint);
      return Touch{
        moment.time, moment.s - drive.front().s + other.wayToStand(moment.time),
        std::max(0.0, other.lastSpeed() * along), ahead, place + outline.half_length < footprint.rear()};
    }
  }
  return std::nullopt;
}
}  // namespace f1tenth_racer
