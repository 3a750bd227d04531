#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "car/car_state.h"
#include "map/costmap.h"
#include "path/path_tracker.h"
#include "path/speed_profile.h"
#include "traffic/forecast.h"
#include "traffic/keeping_behind.h"

namespace move_base
{
struct FollowerOptions
{
  SpeedLimits limits;
  double max_steering_angle{0.4189};  ///< rad
  double latency{0.05};               ///< s, from measuring a pose to the wheels acting on the command
  double tracking_distance{0.45};     ///< m, in which an error of the path is driven out when standing
  double tracking_time{0.12};         ///< s, added to it per m/s
  double slip_gradient{0.0};          ///< rad per m/s^2 of lateral acceleration, that the rear axle drifts outwards
  double understeer_gradient{0.0};    ///< rad per m/s^2, that the wheels must be turned further than on rails
  double load_transfer{0.0};          ///< per m/s^2, part of its load that the rear axle gains and the front one loses
  double yaw_lag{0.0};                ///< s per m/s, by which the yaw follows the wheels
  double stop_clearance{0.0};         ///< m, with less on its predicted way the car stops before
  double replan_distance{2.5};        ///< m beyond the braking distance, an obstacle on the path there is reported
  double max_path_deviation{0.5};     ///< m, farther from its path the car has lost it

  /// @throws OptionError
  void validate() const;
};

/// How late a car does what it is told.
struct Lags
{
  double latency{0.0};  ///< s, from measuring a pose to the wheels acting on the command
  double speed{0.0};    ///< s, that its speed lags behind its command
};

/// What is known of a car's tyres beside what the options say.
struct Tyres
{
  double slip{1.0};      ///< times what the options say
  double traction{1.0};  ///< share of the acceleration told that comes of it, where the car falls behind its command
  bool felt{true};       ///< whether a bend has shown how far they slip
};

struct DriveCommand
{
  double speed{0.0};      ///< m/s, negative backwards
  double curvature{0.0};  ///< 1/m, positive is steering to the left

  double yawRate() const { return speed * curvature; }
  /// rad, of the wheels; straight for a car that stops. @param wheelbase  m
  double steeringAngle(double wheelbase) const { return speed == 0.0 ? 0.0 : std::atan(wheelbase * curvature); }
};

/// What one step of following gives.
struct FollowStep
{
  DriveCommand command;
  PathPosition position;          ///< of the car now
  bool lost{false};               ///< the car is off its path
  bool blocked{false};            ///< an obstacle lies on the path ahead
  bool stuck{false};              ///< the car cannot drive on without touching it
  bool at_end{false};             ///< the path is driven to its end
  std::vector<Pose2> prediction;  ///< where the car is going to be
};

/// Steers a car along a path at the speed that path, obstacles and the car allow.
class PathFollower
{
public:
  static constexpr double kSpeedLag = 0.055;  ///< s, that a car's speed lags behind its command besides the latency

  /// @throws OptionError
  explicit PathFollower(const FollowerOptions & options);

  const FollowerOptions & options() const { return options_; }

  /// Starts on a path, which must have at least one point.
  void setPath(const Path & path, const Costmap & costmap, const Caution & caution = {});
  bool hasPath() const { return !path_.empty(); }
  const Path & path() const { return path_; }
  void clear();
  /// Those of the options until they are set.
  void setLags(const Lags & lags) { lags_ = lags; }
  const Lags & lags() const { return lags_; }
  /// Where the tyres clearly slip more than the options say, or pass on but a share of the acceleration told, they have less
  /// grip, and the car is asked for less; to the side also until a bend has shown it. The speeds along the path follow.
  void setTyres(const Tyres & tyres, const Costmap & costmap);
  const DriveCommand & lastCommand() const { return last_; }
  /// 1/m, of the car's way, that the last command is to bring about.
  double lastBend() const { return last_bend_; }

  /// The path from behind the car to where it will be after the time, s; empty when the car is not on it.
  Path lead(const CarState & car, double time) const;

  /// The car's place on the path, m along it.
  double placeOf(const CarState & car) const { return tracker_.locate(path_, car.pose).s; }

  /// Whether the path goes on for longer than the car needs to stand.
  bool canDriveOn(const CarState & car) const;

  /// Whether somebody is going to be in the way.
  bool hindered(const CarState & car, const Costmap & costmap, const std::vector<Forecast> & others) const;

  /// @param period  s since the last step
  /// @param brake   whether to come to a stand along the path as soon as possible
  /// @param others  who drives about, behind whom it stays
  FollowStep step(
    const CarState & car, const Costmap & costmap, double period, bool brake = false,
    const std::vector<Forecast> & others = {});

private:
  struct Sent
  {
    double duration;  // s
    double bend;      // 1/m, wanted of the car's way
  };

  void noteSent(double period);
  double maxCurvature() const;
  double drivable(double curvature, double speed) const;
  double speedFor(double curvature) const;
  double lateralOn(double curvature, double speed) const;
  double slipOn(double curvature, double speed) const;
  double leftInBend(double speed, double bend) const;
  double gentlest(const CarState & car) const;
  double accelerationTo(double command, double speed) const;
  double withUndersteer(double curvature, double speed, double acceleration) const;
  double curvatureAhead(const PathPosition & position, double speed) const;
  Pose2 afterLatency(const CarState & car) const;
  double steer(const PathPosition & position, double ahead, double speed) const;
  double profileAt(double s, std::size_t from) const;
  double wantedSpeed(const PathPosition & position, double speed) const;
  double distanceToObstacle(const CarState & car, const Costmap & costmap, std::vector<Pose2> & prediction) const;
  OwnWay wayFrom(const PathPosition & here, const CarState & car, const Costmap & costmap) const;
  bool pathBlocked(const PathPosition & position, double speed, const Costmap & costmap) const;
  void changeDirectionWhenStanding(const CarState & car);
  double slewed(double wanted, double speed, bool brake, double period) const;

  FollowerOptions given_;
  FollowerOptions options_;  // as the car is found to be
  Lags lags_;
  Tyres tyres_;
  double grip_to_side_;  // m/s^2: more than is planned with until the tyres have been felt
  Path path_;
  Caution caution_;
  std::vector<double> speeds_;
  PathTracker tracker_;
  DriveCommand last_;
  std::deque<Sent> sent_;
  double last_bend_{0.0};  // 1/m, wanted of the car's way by the last step
};
}  // namespace move_base
