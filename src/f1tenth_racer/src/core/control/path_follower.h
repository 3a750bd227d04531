#pragma once

#include <deque>
#include <vector>

#include <move_base/car.h>
#include <move_base/map/costmap.h>
#include <move_base/path/path_tracker.h>
#include "path/terms.h"
#include "speed/speed_profile.h"
#include "traffic/forecast.h"
#include "traffic/keeping_behind.h"
#include "tyres/handling.h"

namespace f1tenth_racer
{
/// The result of one step of following.
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
  static constexpr double kMaxDeviation = 0.5;  ///< m, a car farther from its path has lost it

  /// @throws OptionError
  explicit PathFollower(const FollowerOptions & options);

  const FollowerOptions & options() const { return handling_.options(); }

  /// Starts on a path, which must have at least one point.
  void setPath(const Path & path, const Costmap & costmap, const Caution & caution = {});
  bool hasPath() const { return !path_.empty(); }
  const Path & path() const { return path_; }
  void clear();
  const Lags & lags() const { return handling_.lags(); }
  /// As Handling::set; the speeds along the path follow.
  void setHandling(const Lags & lags, const Tyres & tyres, const Costmap & costmap);
  const DriveCommand & lastCommand() const { return last_; }
  /// 1/m, the curvature of the car's way that the last command aims at.
  double lastBend() const { return last_bend_; }

  /// The path from behind the car to where it will be after the time, s; empty when the car is not on it.
  Path lead(const CarState & car, double time) const;

  /// The car's place on the path, m along it.
  double placeOf(const CarState & car) const { return tracker_.locate(path_, car.pose).s; }

  /// Whether the path goes on for longer than the car needs to stop.
  bool canDriveOn(const CarState & car) const;

  /// Whether another car is going to be in the way.
  bool hindered(const CarState & car, const Costmap & costmap, const std::vector<Forecast> & others) const;

  /// @param period  s since the last step
  /// @param brake   whether to stop along the path as soon as possible
  /// @param others  that drive about, behind which it stays
  FollowStep step(
    const CarState & car, const Costmap & costmap, double period, bool brake = false,
    const std::vector<Forecast> & others = {});

private:
  struct Sent
  {
    double duration;  // s
    double bend;      // 1/m, wanted for the car's way
  };

  void noteSent(double period);
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

  Handling handling_;
  Path path_;
  Caution caution_;
  std::vector<double> speeds_;
  PathTracker tracker_;
  DriveCommand last_;
  std::deque<Sent> sent_;
  double last_bend_{0.0};  // 1/m, wanted for the car's way by the last step
  double wheels_{0.0};     // rad, to which the commands have turned the wheels
};
}  // namespace f1tenth_racer
