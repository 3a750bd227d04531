#include "amcl/localizer.h"

#include <workspace_support/maths/random.h>
#include <workspace_support/option_checks.h>
#include <workspace_support/scan_checks.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "free_space.h"
#include "likelihood_field.h"
#include "motion_model.h"
#include "particles.h"

namespace amcl
{
namespace
{
constexpr double kFound = 0.3;  // m, standard deviation of converged particles; a car with a wider start is lost
// Where a lost car may be, to be compared with the first scan: hardly one of the usual number is right to a few degrees.
constexpr std::size_t kCandidates = 400000;
// As many are drawn from these at most, and these only when so small a share of them still counts: places that look
// alike must not die out by chance.
constexpr int kLostParticles = 40000;
constexpr double kDepleted = 0.5;
// For a car that is lost, beams count as if this many of them were independent of each other. If all were, one scan
// would leave nothing but the place that fits best, which is often a wrong one.
constexpr double kIndependentBeams = 20.0;
// At the first look fewer, as hardly a candidate is exactly right; then the neighbourhood of those drawn is looked at.
constexpr double kFirstBeams = 2.5;
constexpr double kAbout = 0.1;       // m
constexpr double kTurnAbout = 0.05;  // rad
constexpr double kFarthest = 1e6;    // m between two scans: more is a mistake

double positionVariance(const Estimate & estimate)
{
  return estimate.covariance[0] + estimate.covariance[4];
}

/// Share of the particles that would be as good if their weights were equal.
double effectiveShare(const Particles & particles)
{
  double squares = 0.0;
  for (const WeightedPose & particle : particles) {
    squares += particle.weight * particle.weight;
  }
  return 1.0 / (squares * static_cast<double>(particles.size()));
}

LocalizerOptions optionsOfLost(LocalizerOptions options)
{
  options.max_particles = std::max(options.max_particles, kLostParticles);
  options.kld_err = std::min(options.kld_err, LocalizerOptions{}.kld_err);
  return options;
}

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
    believed_ = estimate.pose;
    const bool is_wide = positionVariance(estimate) > kFound * kFound;
    const auto most = static_cast<std::size_t>(options_.max_particles);
    startWith(drawAround(estimate, is_wide ? kCandidates : most, random_), is_wide);
  }

  void spreadOut() override
  {
    const std::vector<Cell> cells = freeCellsAbout(map_, believed_.position());
    if (cells.empty()) {
      throw Error("nothing is free on the map");
    }
    startWith(drawOn(cells), true);
  }

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
    const std::size_t count = std::min(particles_.size(), static_cast<std::size_t>(options_.max_particles));
    std::vector<Pose2> poses;
    poses.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      poses.push_back(particles_[i * particles_.size() / count].pose);
    }
    return poses;
  }

private:
  void startWith(const std::vector<Pose2> & poses, bool is_lost)
  {
    particles_ = evenly(poses);
    is_lost_ = is_lost;
    odometry_.reset();
    due_ = true;
    updates_ = 0;
    believe();
  }

  std::vector<Pose2> drawOn(const std::vector<Cell> & cells)
  {
    const GridGeometry & geometry = map_.geometry;
    std::vector<Pose2> poses;
    poses.reserve(kCandidates);
    for (std::size_t i = 0; i < kCandidates; ++i) {
      const Cell & cell = cells[static_cast<std::size_t>(random_.uniform() * static_cast<double>(cells.size()))];
      const double x = (cell.x + random_.uniform()) * geometry.resolution;
      const double y = (cell.y + random_.uniform()) * geometry.resolution;
      poses.push_back(compose(geometry.origin, {x, y, random_.uniform(-M_PI, M_PI)}));
    }
    return poses;
  }

  Outcome update(const Pose2 & motion, const Beams & seen)
  {
    if (is_lost_ && updates_ == 0) {
      weighBy([&](const Pose2 & pose) { return kFirstBeams * field_.meanLog(seen, pose); });
      particles_ = resampled(particles_, optionsOfLost(options_), random_);
      for (WeightedPose & particle : particles_) {
        particle.pose.x += kAbout * random_.gaussian();
        particle.pose.y += kAbout * random_.gaussian();
        particle.pose.yaw = normalizeAngle(particle.pose.yaw + kTurnAbout * random_.gaussian());
      }
    }
    const MotionModel model(motion, options_.odometry);
    for (WeightedPose & particle : particles_) {
      particle.pose = model.sample(particle.pose, random_);
    }
    weighBy([&](const Pose2 & pose) {
      return is_lost_ ? kIndependentBeams * field_.meanLog(seen, pose) : field_.logLikelihood(seen, pose);
    });
    ++updates_;
    believe();
    const bool is_due = is_lost_ ? effectiveShare(particles_) < kDepleted : updates_ % options_.resample_interval == 0;
    if (is_due) {
      particles_ = resampled(particles_, is_lost_ ? optionsOfLost(options_) : options_, random_);
    }
    return is_due ? Outcome::kResampled : Outcome::kUpdated;
  }

  template <typename LogLikelihood>
  void weighBy(LogLikelihood log_likelihood)
  {
    std::vector<double> logs;
    logs.reserve(particles_.size());
    for (const WeightedPose & particle : particles_) {
      logs.push_back(log_likelihood(particle.pose));
    }
    weigh(particles_, logs);
  }

  /// Until the particles of a lost car have converged, it may just as well be somewhere else than most of them.
  void believe()
  {
    estimate_ = heaviestCluster(particles_);
    if (is_lost_) {
      const Estimate all = estimateOf(particles_);
      is_lost_ = updates_ == 0 || positionVariance(all) > kFound * kFound;
      estimate_.covariance = all.covariance;
    }
  }

  LocalizerOptions options_;
  OccupancyGrid map_;
  LikelihoodField field_;
  maths::Random random_;
  Particles particles_;
  Estimate estimate_;
  std::optional<Pose2> odometry_;  // at the last scan that counted
  Pose2 believed_;                 // where the car was last said to be
  bool has_seen_{false};
  bool due_{true};
  bool is_lost_{false};
  int updates_{0};
};
}  // namespace

std::unique_ptr<Localizer> Localizer::make(
  const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
{
  return std::make_unique<ParticleLocalizer>(map, options, start);
}
}  // namespace amcl
