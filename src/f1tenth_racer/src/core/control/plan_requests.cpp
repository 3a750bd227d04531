#include "control/plan_requests.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kGatePart = 0.6;         // of the goal tolerance, within which plans pass goals
constexpr double kGateYawPart = 0.65;     // the same for the heading, which slip changes as well
constexpr double kLeadTime = 0.1;         // s beyond the latency, for which a new plan keeps to the old one
constexpr double kApproachLength = 3.0;   // m, on top of the braking distance, that are planned to the goal itself
constexpr double kApproachMargin = 1.0;   // m
constexpr double kTooFast = 0.2;          // m/s, by which a car may be faster than a new plan allows
constexpr double kFarTooFast = 1.5;       // m/s, the same for a plan that is not to end at a standstill
constexpr double kExtensionMargin = 1.0;  // m, of a plan beyond the goal, on top of the braking distance
}  // namespace

PlanRequest PlanRequests::from(const CarState & car, double time_needed, const PathFollower & way) const
{
  const double curvature = follower_.lastCommand().curvature;
  PlanRequest request{advance(car.pose, car.speed * follower_.lags().latency, curvature), goals_.front(), curvature};
  if (passes()) {
    request.extension_length = extensionLength();
  }
  if (races(car, time_needed)) {
    const SpeedLimits & limits = follower_.options().limits;
    request.race_line = RaceLineOptions{
      kGatePart * tolerance().distance,
      kGateYawPart * tolerance().yaw,
      follower_.options().slip_gradient,
      limits.max_lateral_acceleration,
      limits.max_vel_x,
      goals_.next()};
  }
  if (options_.race_line || time_needed > 0.0) {
    request.lead = way.lead(car, leadTime(time_needed));
  }
  if (!request.lead.empty()) {
    request.lead_time = leadTime(time_needed);
    request.start = request.lead.back().pose;
    request.start_curvature = request.lead.back().curvature;
  }
  return request;
}

double PlanRequests::leadTime(double time_needed) const
{
  return follower_.lags().latency + kLeadTime + time_needed;
}

bool PlanRequests::canDrive(const Plan & plan, const CarState & car, const Costmap & costmap) const
{
  if (car.speed < kTooFast) {
    return true;
  }
  const std::size_t nearest = nearestTo(plan.path, car.pose);
  const Pose2 & place = plan.path[nearest].pose;
  const std::vector<double> speeds = speedProfile(plan.path, costmap, follower_.options().limits);
  const Vec2 from_path = car.pose.position() - place.position();
  const Vec2 ahead{maths::cos(place.yaw), maths::sin(place.yaw)};
  const bool on_path = std::abs(cross(ahead, from_path)) <= PathFollower::kMaxDeviation;
  // Until it becomes slower it drives on for a while.
  const double soon = plan.path[nearest].s + (passes() ? 0.0 : car.speed * follower_.lags().speed);
  const double allowed = speeds[firstBeyond(plan.path, soon, nearest)] + (passes() ? kFarTooFast : kTooFast);
  const double stop = plan.path[nearest].s + follower_.options().limits.brakingDistance(car.speed);
  const bool turns = std::any_of(
    plan.path.begin(), plan.path.end(), [&](const PathPoint & point) { return point.s <= stop && point.reverse; });
  return on_path && !turns && car.speed <= allowed;
}

bool PlanRequests::isFar(double way, double speed, double time_needed) const
{
  return way >= approachLength(speed, time_needed);
}

// A race line does not end at the goal's pose: the last stretch is planned to the goal itself.
bool PlanRequests::races(const CarState & car, double time_needed) const
{
  const bool far = distance(car.pose, goals_.front()) > approachLength(car.speed, time_needed) + kApproachMargin;
  return options_.free_goal_vel && options_.race_line && (goals_.anyNext() || far);
}

double PlanRequests::approachLength(double speed, double time_needed) const
{
  return follower_.options().limits.brakingDistance(speed) + kApproachLength + std::abs(speed) * time_needed;
}

double PlanRequests::extensionLength() const
{
  const SpeedLimits & limits = follower_.options().limits;
  const double longest =
    limits.brakingDistance(limits.max_vel_x) + limits.max_vel_x * options_.coast_time + kExtensionMargin;
  return std::min(longest, goals_.wayToLast());
}
}  // namespace f1tenth_racer
