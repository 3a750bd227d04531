// How calmly a car with sliding tyres follows its path at speed, with the gains of f1tenth_navigation.
#include <gtest/gtest.h>

#include "control/path_follower.h"
#include "roads.h"
#include "sliding_car.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawRoom;
using testing::makeCostmap;
using testing::SlidingCar;

constexpr double kControlStep = 0.025;  // s

FollowerOptions shippedFollower(double speed)
{
  FollowerOptions options;
  options.limits.max_vel_x = speed;
  options.limits.max_vel_theta = 8.0;
  options.limits.acc_lim_x = options.limits.dec_lim_x = 7.0;
  options.limits.braking_power = 20.0;
  options.limits.max_lateral_acceleration = 7.0;
  options.limits.full_speed_clearance = 0.1;
  options.limits.slowest_clearance = 0.0;
  options.slip_gradient = 0.0178;
  options.limits.understeer_gradient = 0.0028;
  options.load_transfer = 0.0457;
  options.yaw_lag = 0.02;
  options.tracking_time = 0.25;
  return options;
}

struct Ride
{
  double speed;
  double friction;
  double latency;
};

std::ostream & operator<<(std::ostream & out, const Ride & ride)
{
  return out << ride.speed << " m/s, friction " << ride.friction << ", latency " << ride.latency << " s";
}

class Tracking : public ::testing::TestWithParam<Ride>
{
protected:
  static double slip() { return 1.05 / GetParam().friction; }

  // Calls seen(time, car, position) after each step of a drive along a path.
  template <typename Seen>
  void follow(const Path & path, const Pose2 & start, double duration, Seen seen)
  {
    const Costmap costmap = makeCostmap(drawRoom(100.0, 40.0));
    PathFollower follower(shippedFollower(GetParam().speed));
    const Lags told = follower.lags();
    const double late = GetParam().latency;
    follower.setHandling({told.latency + late, told.speed + late}, {slip()}, costmap);
    follower.setPath(path, costmap);
    SlidingCar car(start, GetParam().speed, GetParam().friction, GetParam().latency);
    for (double t = 0.0; t < duration; t += kControlStep) {
      const FollowStep step = follower.step(car.state(), costmap, kControlStep);
      ASSERT_FALSE(step.lost) << t;
      car.drive(step.command, kControlStep);
      seen(t, car, step.position);
    }
  }
};

TEST_P(Tracking, drivesAnErrorOutWithoutWeaving)
{
  int changes = 0;
  double last = 0.0;
  double lateral = 1.0;
  follow(
    samplePath({2.0, 20.0, 0.0}, {{96.0, 0.0}}, 0.1), {2.0, 20.1, 0.0}, 4.0,
    [&](double, const SlidingCar & car, const PathPosition & position) {
      const double rate = std::abs(car.yawRate()) > 0.02 ? car.yawRate() : 0.0;
      changes += rate * last < 0.0 ? 1 : 0;
      last = rate != 0.0 ? rate : last;
      lateral = position.lateral;
    });
  EXPECT_LE(changes, 4);
  EXPECT_NEAR(lateral, 0.0, 0.03);
}

using TrackingOfBends = Tracking;

TEST_P(TrackingOfBends, brakesIntoABendWithinTheLimits)
{
  const double start = 50.0;  // m before the bend, and after it
  double lateral = 0.0;
  double off = 0.0;
  // Steered in and out over 1 m each, as a smooth path is.
  const std::vector<Arc> arcs{{start, 0.0}, {1.0, 0.1}, {1.0, 0.2}, {4.0, 0.3}, {1.0, 0.2}, {1.0, 0.1}, {15.0, 0.0}};
  follow(
    samplePath({2.0, 5.0, 0.0}, arcs, 0.1), {2.0, 5.0, 0.0}, 8.0,
    [&](double t, const SlidingCar & car, const PathPosition & position) {
      if (t > 0.5) {
        lateral = std::max(lateral, std::abs(car.lateralAcceleration()));
        off = std::max(off, std::abs(position.lateral));
      }
    });
  EXPECT_LT(lateral, 1.1 * 7.0 * std::min(1.0, std::pow(1.15 / slip(), 1.5)));
  EXPECT_LT(off, 0.3);
}

INSTANTIATE_TEST_SUITE_P(
  SpeedLatencyAndFriction, Tracking,
  ::testing::Values(
    Ride{4.0, 1.05, 0.0}, Ride{4.0, 1.05, 0.1}, Ride{4.0, 0.5, 0.02}, Ride{7.0, 1.05, 0.0}, Ride{7.0, 1.05, 0.02},
    Ride{7.0, 1.05, 0.1}, Ride{7.0, 0.5, 0.02}, Ride{10.0, 1.05, 0.0}, Ride{10.0, 1.05, 0.02}, Ride{10.0, 1.05, 0.1},
    Ride{10.0, 0.5, 0.02}));
INSTANTIATE_TEST_SUITE_P(
  SpeedLatencyAndFriction, TrackingOfBends,
  ::testing::Values(
    Ride{4.0, 1.05, 0.0}, Ride{4.0, 1.05, 0.02}, Ride{4.0, 1.05, 0.1}, Ride{4.0, 0.5, 0.02}, Ride{7.0, 1.05, 0.0},
    Ride{7.0, 1.05, 0.02}, Ride{7.0, 1.05, 0.1}, Ride{7.0, 0.5, 0.02}, Ride{10.0, 1.05, 0.0}, Ride{10.0, 1.05, 0.02},
    Ride{10.0, 1.05, 0.1}, Ride{10.0, 0.5, 0.02}));
}  // namespace
}  // namespace f1tenth_racer
