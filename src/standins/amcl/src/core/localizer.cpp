#include "amcl/localizer.h"

#include <workspace_support/maths/random.h>
#include <workspace_support/option_checks.h>
#include <workspace_support/scan_checks.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "likelihood_field.h"
#include "motion_model.h"
#include "particles.h"

namespace amcl
{
namespace
{
constexpr double kFarthest = 1e6;  // m between two scans: more is a mistake

class ParticleLocalizer final : public Localizer
{
public:
  ParticleLocalizer(const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
  : options_(options), map_(map), field_(map, options.laser), random_(options.seed)
  {
    setPose(start);
  }

  void setPose(const Estimate & estimate) override
  {
    startWith(drawAround(estimate, static_cast<std::size_t>(options_.max_particles), random_));
  }

  void spreadOut() override { startWith(drawOn(freeCells())); }

  void updateNext() override { due_ = true; }

  Outcome process(const Scan & scan, const Pose2 & lidar, const Pose2 & odometry) override
  {
    requireUsable(scan);
    const Pose2 motion = odometry_ ? compose(inverse(*odometry_), odometry) : Pose2{};
    const double way = norm(motion.position());
    requireOption(way <= kFarthest, "way of odometry", way, "at most 1e+06");
    const bool is_far = way > options_.update_min_d || std::abs(motion.yaw) > options_.update_min_a;
    if (scan.ranges.size() < 2 || (!due_ && !is_far)) {
      return Outcome::kIgnored;
    }
    if (!has_seen_) {
      field_.setRangeMax(scan.range_max);
      has_seen_ = true;
    }
    due_ = false;
    odometry_ = odometry;
    return update(motion, usedBeams(scan, lidar, options_.laser));
  }

  Estimate estimate() const override
  {
    Estimate estimate = estimate_;
    // The particles cannot know that the map is only right to half a cell.
    const double half_cell = 0.5 * map_.geometry.resolution;
    estimate.covariance[0] += half_cell * half_cell;
    estimate.covariance[4] += half_cell * half_cell;
    return estimate;
  }

  std::vector<Pose2> particles() const override
  {
    std::vector<Pose2> poses(particles_.size());
    std::transform(particles_.begin(), particles_.end(), poses.begin(), [](auto & each) { return each.pose; });
    return poses;
  }

private:
  void startWith(const std::vector<Pose2> & poses)
  {
    particles_ = evenly(poses);
    odometry_.reset();
    due_ = true;
    updates_ = 0;
    estimate_ = heaviestCluster(particles_);
  }

  std::vector<Cell> freeCells() const
  {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < map_.cells.size(); ++i) {
      if (map_.cells[i] == 0) {
        cells.push_back(map_.geometry.cell(i));
      }
    }
    if (cells.empty()) {
      throw Error("nothing is free on the map");
    }
    return cells;
  }

  std::vector<Pose2> drawOn(const std::vector<Cell> & cells)
  {
    const GridGeometry & geometry = map_.geometry;
    std::vector<Pose2> poses;
    for (int i = 0; i < options_.max_particles; ++i) {
      const Cell & cell = cells[static_cast<std::size_t>(random_.uniform() * static_cast<double>(cells.size()))];
      const double x = (cell.x + random_.uniform()) * geometry.resolution;
      const double y = (cell.y + random_.uniform()) * geometry.resolution;
      poses.push_back(compose(geometry.origin, {x, y, random_.uniform(-M_PI, M_PI)}));
    }
    return poses;
  }

  Outcome update(const Pose2 & motion, const Beams & seen)
  {
    const MotionModel model(motion, options_.odometry);
    for (WeightedPose & particle : particles_) {
      particle.pose = model.sample(particle.pose, random_);
    }
    std::vector<double> logs;
    logs.reserve(particles_.size());
    for (const WeightedPose & particle : particles_) {
      logs.push_back(field_.logLikelihood(seen, particle.pose));
    }
    weigh(particles_, logs);
    estimate_ = heaviestCluster(particles_);
    if (++updates_ % options_.resample_interval != 0) {
      return Outcome::kUpdated;
    }
    particles_ = resampled(particles_, options_, random_);
    return Outcome::kResampled;
  }

  LocalizerOptions options_;
  OccupancyGrid map_;
  LikelihoodField field_;
  maths::Random random_;
  Particles particles_;
  Estimate estimate_;
  std::optional<Pose2> odometry_;  // at the last scan that counted
  bool has_seen_{false};
  bool due_{true};
  int updates_{0};
};
}  // namespace

std::unique_ptr<Localizer> Localizer::make(
  const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
{
  return std::make_unique<ParticleLocalizer>(map, options, start);
}
}  // namespace amcl
