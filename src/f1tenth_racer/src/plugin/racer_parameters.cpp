#include "racer_parameters.h"

#include <move_base/planner_parameters.h>

namespace f1tenth_racer
{
namespace
{
// Reads parameters in the namespace of the local planner.
class Reader
{
public:
  explicit Reader(const PlannerSetup & setup) : setup_(setup) {}

  template <class Value>
  void operator()(const std::string & name, Value & value) const
  {
    setup_.parameters.read(ofPlanner(setup_.local_planner, name), value);
  }

private:
  const PlannerSetup & setup_;
};

void readSpeedLimits(const Reader & read, SpeedLimits & limits)
{
  read("max_vel_x_backwards", limits.max_vel_x_backwards);
  read("max_vel_theta", limits.max_vel_theta);
  read("acc_lim_x", limits.acc_lim_x);
  limits.dec_lim_x = limits.acc_lim_x;
  read("dec_lim_x", limits.dec_lim_x);
  read("braking_power", limits.braking_power);
  read("max_lateral_acceleration", limits.max_lateral_acceleration);
  read("max_steering_rate", limits.max_steering_rate);
  read("understeer_gradient", limits.understeer_gradient);
  read("full_speed_clearance", limits.full_speed_clearance);
  read("slowest_clearance", limits.slowest_clearance);
}

void readFollower(const Reader & read, FollowerOptions & follower)
{
  read("latency", follower.latency);
  read("tracking_distance", follower.tracking_distance);
  read("tracking_time", follower.tracking_time);
  read("slip_gradient", follower.slip_gradient);
  read("load_transfer", follower.load_transfer);
  read("yaw_lag", follower.yaw_lag);
  read("stop_clearance", follower.stop_clearance);
  read("replan_distance", follower.replan_distance);
  read("max_path_deviation", follower.max_path_deviation);
}

void readGoals(const Reader & read, RacerOptions & options)
{
  read("xy_goal_tolerance", options.goal_tolerance.distance);
  read("yaw_goal_tolerance", options.goal_tolerance.yaw);
  read("free_goal_vel", options.free_goal_vel);
  read("via_xy_tolerance", options.via_tolerance.distance);
  read("via_yaw_tolerance", options.via_tolerance.yaw);
  read("race_line", options.race_line);
  read("coast_time", options.coast_time);
}
}  // namespace

RacerOptions readRacer(const PlannerSetup & setup)
{
  const Reader read(setup);
  RacerOptions options;
  SpeedLimits & limits = options.follower.limits;
  readSpeeds(setup, limits.max_vel_x, limits.min_vel_x);
  readSpeedLimits(read, limits);
  readSteering(setup, limits.wheelbase, limits.max_steering_angle);
  readFollower(read, options.follower);
  readGoals(read, options);
  options.planner = readWayPlanner(setup);
  setup.parameters.check([&] { options.validate(); });
  return options;
}
}  // namespace f1tenth_racer
