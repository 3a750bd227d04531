#include "gmapping/grid_slam.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "beams.h"
#include "cell_map.h"
#include "particle_filter.h"
#include "scan_matcher.h"

namespace gmapping
{
namespace
{
// A reading of exactly the greatest range is none.
constexpr double kShortOfMaxRange = 0.01;  // m

struct Particle
{
  Pose2 pose;
  CellMap map;
  double log_weight{0.0};      // since the last resampling
  double log_weight_sum{0.0};  // of the whole path
};

}  // namespace

class GridSlam::Impl
{
public:
  explicit Impl(const SlamOptions & options) : options_(options), matcher_(options.matcher), random_(options.seed) {}

  bool process(const Scan & scan, const Pose2 & odometry, double time)
  {
    if (!odometry_) {
      start(scan, odometry, time);
      return true;
    }
    drive(odometry);
    if (!due(time)) {
      return false;
    }
    last_time_ = time;
    update(hitBeams(scan, max_range_));
    progress_ = {};
    motion_ = {};
    return true;
  }

  const Particle & best() const
  {
    assert(!particles_.empty());
    return *std::max_element(particles_.begin(), particles_.end(), [](const Particle & a, const Particle & b) {
      return a.log_weight_sum < b.log_weight_sum;
    });
  }

  bool empty() const { return particles_.empty(); }
  double entropy() const { return weightEntropy(weights_); }
  const SlamOptions & options() const { return options_; }

private:
  void start(const Scan & scan, const Pose2 & odometry, double time)
  {
    odometry_ = odometry;
    last_time_ = time;
    max_range_ = options_.max_range.value_or(scan.range_max - kShortOfMaxRange);
    max_urange_ = options_.max_urange.value_or(max_range_);
    Particle particle{odometry, CellMap(options_.delta)};
    registerBeams(particle.map, hitBeams(scan, max_range_), particle.pose, max_urange_);
    particles_.assign(options_.particles, particle);
    weights_.assign(options_.particles, 1.0 / options_.particles);
  }

  void drive(const Pose2 & odometry)
  {
    const Pose2 motion = compose(inverse(*odometry_), odometry);
    odometry_ = odometry;
    motion_ = compose(motion_, motion);
    progress_.distance += std::hypot(motion.x, motion.y);
    progress_.turn += std::abs(motion.yaw);
  }

  bool due(double time) const
  {
    const bool waited = options_.temporal_update >= 0.0 && time - last_time_ > options_.temporal_update;
    return progress_.distance >= options_.linear_update || progress_.turn >= options_.angular_update || waited;
  }

  void update(const std::vector<Beam> & beams)
  {
    for (Particle & particle : particles_) {
      correct(particle, beams, &particle == &particles_.front());
    }
    weigh();
    if (effectiveCount(weights_) < options_.resample_threshold * options_.particles) {
      resample();
    }
    for (Particle & particle : particles_) {
      registerBeams(particle.map, beams, particle.pose, max_urange_);
    }
  }

  // One particle follows the most likely poses: the noise drawn for the others adds up over a lap.
  void correct(Particle & particle, const std::vector<Beam> & beams, bool most_likely)
  {
    const PoseBelief expected = expectedPose(particle.pose, motion_, progress_, options_.motion);
    const PoseBelief matched = matcher_.match(particle.map, beams, expected);
    const bool fits = matcher_.score(particle.map, beams, matched.mean) > options_.matcher.minimum_score;
    const PoseBelief & belief = fits ? matched : expected;
    particle.pose = most_likely ? belief.mean : drawPose(belief, random_);
    const double log_likelihood = matcher_.logLikelihood(particle.map, beams, particle.pose);
    particle.log_weight += log_likelihood;
    particle.log_weight_sum += log_likelihood;
  }

  void weigh()
  {
    std::vector<double> log_weights(particles_.size());
    std::transform(particles_.begin(), particles_.end(), log_weights.begin(), [](const Particle & particle) {
      return particle.log_weight;
    });
    weights_ = normalizedWeights(log_weights, options_.ogain * options_.particles);
  }

  void resample()
  {
    const std::vector<std::size_t> chosen = drawParticles(weights_, random_);
    std::vector<Particle> next;
    next.reserve(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      // The map of a particle that is not needed again need not be copied.
      const bool last = i + 1 == chosen.size() || chosen[i + 1] != chosen[i];
      Particle & parent = particles_[chosen[i]];
      next.push_back(last ? std::move(parent) : parent);
      next.back().log_weight = 0.0;
    }
    particles_ = std::move(next);
    weights_.assign(particles_.size(), 1.0 / static_cast<double>(particles_.size()));
  }

  SlamOptions options_;
  ScanMatcher matcher_;
  mrpt::random::CRandomGenerator random_;
  std::vector<Particle> particles_;
  std::vector<double> weights_;
  std::optional<Pose2> odometry_;
  Pose2 motion_;            // since the last scan that counted, in the frame of the lidar then
  Progress progress_;       // since then
  double last_time_{0.0};   // s
  double max_range_{0.0};   // m
  double max_urange_{0.0};  // m
};

GridSlam::GridSlam(const SlamOptions & options)
{
  options.validate();
  impl_ = std::make_unique<Impl>(options);
}
GridSlam::~GridSlam() = default;
GridSlam::GridSlam(GridSlam &&) noexcept = default;
GridSlam & GridSlam::operator=(GridSlam &&) noexcept = default;

bool GridSlam::process(const Scan & scan, const Pose2 & odometry, double time)
{
  return impl_->process(scan, odometry, time);
}
Pose2 GridSlam::pose() const
{
  return impl_->empty() ? Pose2{} : impl_->best().pose;
}
double GridSlam::entropy() const
{
  return impl_->entropy();
}
OccupancyGrid GridSlam::map() const
{
  return impl_->best().map.grid(impl_->options());
}
}  // namespace gmapping
