#include "tyres/slip_watch.h"

#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kWindow = 0.1;             // s, over which a car's course is measured
constexpr double kLongest = 0.3;            // s, over which it no longer is
constexpr double kLeastSpeed = 1.5;         // m/s
constexpr double kLeastAcceleration = 1.0;  // m/s^2
constexpr double kMostAcceleration = 20.0;  // m/s^2, beyond it the pose has jumped
constexpr double kGreatestSlip = 0.6;       // rad, beyond it as well, or the car spins
constexpr double kSlipForgetting = 0.005;   // per measurement
}  // namespace

// Least squares; what has been measured long ago fades.
void SlipWatch::note(double time, const Pose2 & pose)
{
  if (!places_.empty() && time <= places_.back().time) {
    if (time < places_.back().time) {
      places_.clear();
    }
    return;
  }
  places_.push_back({time, pose});
  while (places_.size() > 2 && time - places_[1].time >= kWindow) {
    places_.pop_front();
  }
  const Place & before = places_.front();
  const double duration = time - before.time;
  if (duration < kWindow - 1e-6 || duration > kLongest) {
    return;
  }
  const Vec2 way = pose.position() - before.pose.position();
  const double speed = maths::hypot(way.x, way.y) / duration;
  const double turn = normalizeAngle(pose.yaw - before.pose.yaw);
  const double acceleration = speed * turn / duration;
  const double slip = normalizeAngle(before.pose.yaw + 0.5 * turn - maths::atan2(way.y, way.x));
  const bool corners = std::abs(acceleration) >= kLeastAcceleration && std::abs(acceleration) <= kMostAcceleration;
  if (speed < kLeastSpeed || !corners || std::abs(slip) > kGreatestSlip) {
    return;
  }
  slip_times_acceleration_ += slip * acceleration - kSlipForgetting * slip_times_acceleration_;
  squared_acceleration_ += acceleration * acceleration - kSlipForgetting * squared_acceleration_;
}
}  // namespace f1tenth_racer
