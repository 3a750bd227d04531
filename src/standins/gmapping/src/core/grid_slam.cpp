#include "gmapping/grid_slam.h"

#include <workspace_support/scan_checks.h>

#include <Eigen/LU>
#include <optional>
#include <utility>
#include <vector>

#include "beams.h"
#include "cell_map.h"
#include "loop_finder.h"
#include "motion.h"
#include "pose_graph.h"
#include "scan_tracker.h"

namespace gmapping
{
namespace
{
// A reading of exactly the greatest range is not a hit.
constexpr double kShortOfMaxRange = 0.01;  // m
// Walls and beams are not as exact as thousands of beams together claim: standard deviations from one stop to the next.
constexpr double kLeastError = 0.001;      // m
constexpr double kLeastTurnError = 3e-4;   // rad
constexpr double kTurnErrorRate = 1.5e-3;  // rad per rad
// Wheels slip alike for a while, which adds up faster than independent errors: standard deviations of odometry in the
// graph for one of the options.
constexpr double kSlip = 4.0;
// Errors of a loop, as an earlier map is not exact either.
constexpr double kLoopError = 0.01;       // m
constexpr double kLoopTurnError = 0.002;  // rad
// Rebuilding the map takes a while: not for less than this.
constexpr double kMoved = 0.01;  // m

/// The same, seen in the frame of a pose, and never more certain than these standard deviations (m, rad).
Eigen::Matrix3d seenFrom(const Pose2 & pose, const Eigen::Matrix3d & information, double error, double turn_error)
{
  const Eigen::Matrix3d turned = turnMatrix(-pose.yaw) * information * turnMatrix(pose.yaw);
  const Eigen::Vector3d least(error * error, error * error, turn_error * turn_error);
  return (turned.inverse() + Eigen::Matrix3d(least.asDiagonal())).inverse();
}

class GraphSlam final : public GridSlam
{
public:
  explicit GraphSlam(const SlamOptions & options)
  : options_(options), tracker_(options.matcher, options.motion), loops_(options.matcher), map_(options.delta)
  {
  }

  bool process(const Scan & scan, const Pose2 & odometry, double time) override
  {
    requireUsable(scan);
    if (!odometry_) {
      start(scan, odometry, time);
      return true;
    }
    drive(odometry);
    const bool counts = due(time);
    if (!counts && !tracker_.isDue()) {
      return false;
    }
    std::vector<Beam> beams = hitBeams(scan, max_range_);
    tracker_.look(beams);
    if (counts) {
      last_time_ = time;
      update(std::move(beams));
      progress_ = {};
      motion_ = {};
    }
    return counts;
  }

  const std::vector<Pose2> & path() const override { return graph_.poses(); }
  Pose2 pose() const override { return way_.empty() ? Pose2{} : graph_.poses().back(); }

  OccupancyGrid map() override
  {
    if (hasMoved()) {
      map_ = CellMap(options_.delta);
      mapped_.clear();
    }
    for (std::size_t i = mapped_.size(); i < way_.size(); ++i) {
      registerBeams(map_, way_[i].beams, graph_.poses()[i], max_urange_);
      mapped_.push_back(graph_.poses()[i]);
    }
    return map_.grid(options_);
  }

private:
  void start(const Scan & scan, const Pose2 & odometry, double time)
  {
    max_range_ = options_.max_range.value_or(scan.range_max - kShortOfMaxRange);
    max_urange_ = options_.max_urange.value_or(max_range_);
    std::vector<Beam> beams = hitBeams(scan, max_range_);
    tracker_.start(beams, odometry, max_urange_);  // throws, or the scan counts
    add({odometry, std::move(beams), 0.0}, odometry);
    odometry_ = odometry;
    last_time_ = time;
  }

  void drive(const Pose2 & odometry)
  {
    const Pose2 motion = compose(inverse(*odometry_), odometry);
    odometry_ = odometry;
    motion_ = compose(motion_, motion);
    progress_.add(motion);
    tracker_.drive(motion);
  }

  bool due(double time) const
  {
    const bool waited = options_.temporal_update >= 0.0 && time - last_time_ > options_.temporal_update;
    return progress_.distance >= options_.linear_update || progress_.turn >= options_.angular_update || waited;
  }

  void update(std::vector<Beam> beams)
  {
    const Stop & last = way_.back();
    const Pose2 local = tracker_.pose();
    PoseEdge edge{way_.size() - 1, way_.size(), compose(inverse(last.local), local), {}, false};
    edge.information = expectedPose(last.local, motion_, progress_, options_.motion).information / (kSlip * kSlip);
    edge.information += tracker_.information();
    const double turn_error = kLeastTurnError + kTurnErrorRate * progress_.turn;
    edge.information = seenFrom(last.local, edge.information, kLeastError, turn_error);
    add({local, std::move(beams), last.distance + progress_.distance}, compose(pose(), edge.relative));
    graph_.connect(edge);
    closeLoop();
  }

  void add(Stop stop, const Pose2 & pose)
  {
    way_.push_back(std::move(stop));
    graph_.add(pose);
  }

  void closeLoop()
  {
    if (auto loop = loops_.find(way_, graph_.poses())) {
      loop->information = seenFrom({}, loop->information, kLoopError, kLoopTurnError);
      if (loop->is_firm) {
        // What a straight told before may be off: how far along it the car was is known only now.
        graph_.keepFirm();
      }
      graph_.connect(*loop);
      graph_.optimize();
    }
  }

  bool hasMoved() const
  {
    for (std::size_t i = 0; i < mapped_.size(); ++i) {
      if (distance(mapped_[i], graph_.poses()[i]) > kMoved) {
        return true;
      }
    }
    return false;
  }

  SlamOptions options_;
  ScanTracker tracker_;
  LoopFinder loops_;
  Way way_;
  PoseGraph graph_;  // a pose for each stop
  CellMap map_;      // of the first stops, at the poses in mapped_
  std::vector<Pose2> mapped_;
  std::optional<Pose2> odometry_;
  Pose2 motion_;            // since the last scan that counted, in the frame of the lidar then
  Progress progress_;       // since then
  double last_time_{0.0};   // s
  double max_range_{0.0};   // m
  double max_urange_{0.0};  // m
};
}  // namespace

std::unique_ptr<GridSlam> GridSlam::make(const SlamOptions & options)
{
  options.validate();
  return std::make_unique<GraphSlam>(options);
}
}  // namespace gmapping
