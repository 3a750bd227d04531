#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "path/terms.h"
#include "seen/box.h"

namespace f1tenth_racer
{
/// Where the middle of something was, and when.
struct Sight
{
  double time{0.0};  ///< s
  Pose2 pose;        ///< its heading is that of the motion
};

/// Something that drives about, as the lidar saw it last.
struct MovingObstacle
{
  Box outline;                ///< at least as large as a car; its heading is that of the motion
  double speed{0.0};          ///< m/s
  double seen{0.0};           ///< s, when
  std::deque<Sight> trail{};  ///< where it has been in the last seconds, the oldest first
};

/// Something that drove about and came to a stand, or that is all one sees of a low car that stands: its lidar.
struct StoppedObstacle
{
  Box outline;        ///< at least as large as a car
  Vec2 seen;          ///< m, a point inside of what the lidar sees of it
  bool headed{true};  ///< whether the outline's heading is known
};

/// Tells what moves from what stands, from scan to scan: hits near to each other are one obstacle, and how fast it is
/// follows from how its edges move. Of two opposite edges the slower one counts, because an edge also moves when more
/// of an obstacle comes into sight, or less.
class ObstacleTracker
{
public:
  /// @param time    s; when it is not later than the last one, everything known before is forgotten
  /// @param sensor  where the lidar is, m
  /// @param hits    what it hit that is not on the map, in the order of its beams, m
  void observe(double time, const Vec2 & sensor, const std::vector<Vec2> & hits);

  /// What moves, and was seen at most a moment ago.
  const std::vector<MovingObstacle> & moving() const { return moving_; }
  /// What drove about or may be a car, stands now, and was seen at most a moment ago.
  const std::vector<StoppedObstacle> & stopped() const { return stopped_; }
  /// Where something was seen for too short a time to tell whether it stands, and is no longer seen.
  const std::vector<Box> & glimpses() const { return glimpses_; }

private:
  struct Sighting
  {
    double time;
    Vec2 low;   // m, of the upright rectangle around the hits
    Vec2 high;  // m
  };
  using Cluster = std::vector<Vec2>;
  static constexpr double kStandsAfter = 1.0;  // s without moving

  class Track
  {
  public:
    Track(double time, Cluster hits) { see(time, std::move(hits)); }

    double lastSeen() const { return sightings_.back().time; }
    /// Where its middle is expected, m.
    Vec2 expected(double time) const;
    void see(double time, Cluster hits);
    /// Whether it has been seen for long enough to tell whether it moves.
    bool decided() const { return decided_; }
    /// The upright rectangle around all that was seen of it in a moment.
    Box extent() const;
    bool moves() const { return last_moved_ && lastSeen() <= *last_moved_ + kStandsAfter; }
    /// Whether it drove some way when it last moved.
    bool hasDriven() const;
    /// Whether it has never moved and is no larger than the lidar of a low car.
    bool mayBeTop() const;
    Box outline(const Vec2 & sensor) const;
    MovingObstacle obstacle(const Vec2 & sensor) const
    {
      return {outline(sensor), norm(velocity_), lastSeen(), trail_};
    }
    StoppedObstacle stopped(const Vec2 & sensor) const;
    void noteTrail(const Vec2 & sensor);

  private:
    void estimateVelocity();

    std::deque<Sighting> sightings_;
    std::deque<Sight> trail_;
    Cluster hits_;
    Vec2 velocity_;  // m/s
    bool decided_{false};
    double heading_{0.0};               // rad, of the motion
    std::optional<double> last_moved_;  // s; nothing if it never did
  };

  static std::vector<Cluster> clustersOf(const std::vector<Vec2> & hits);
  void forgetLost(double time);
  void assign(double time, std::vector<Cluster> clusters);

  std::vector<Track> tracks_;
  std::vector<MovingObstacle> moving_;
  std::vector<StoppedObstacle> stopped_;
  std::vector<Box> glimpses_;
  double last_time_{0.0};
  std::optional<Vec2> begin_;  // m, where the lidar was at first
  bool has_driven_{false};     // before, others may be waiting for the same start
};
}  // namespace f1tenth_racer
