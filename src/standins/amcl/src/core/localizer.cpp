#include "amcl/localizer.h"

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>
#include <workspace_support/errors.h>
#include <workspace_support/scan_checks.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "clusters.h"
#include "engine_types.h"
#include "lost_car.h"
#include "motion_model.h"
#include "road.h"

namespace amcl
{
namespace
{
// The original sums up cubes of the beams' likelihoods; the cube of their mean is close to that.
constexpr double kAveragePower = 3.0;
// For a car that is lost, beams count as if this many of them were independent of each other. If all were, one scan
// would leave nothing but the place that fits best, which is often a wrong one.
constexpr double kIndependentBeams = 5.4;
constexpr double kFound = 0.3;  // m, standard deviation of converged particles; a car with a wider start is lost
constexpr std::size_t kPlacesAbout = 20000;  // that are checked if it is known roughly where the car is
constexpr double kPlaceError = 0.05;         // m, standard deviation of particles about a place where the car was found
constexpr double kHeadingError = 0.01;       // rad
constexpr double kFarthest = 1e6;            // m between two scans: more is a mistake, and overflows in MRPT
// MRPT throws for a motion less certain than this, a leap of a few metres, unless it is declared to come from a scan.
constexpr double kMostUncertain = 500.0;  // m^4 rad^2, determinant of the covariance; 1000 is MRPT's
// So that no covariance is singular.
constexpr double kLeastVariance = 1e-8;  // m^2 and rad^2

mrpt::slam::TKLDParams kldOptions(const LocalizerOptions & options)
{
  mrpt::slam::TKLDParams kld;
  kld.KLD_binSize_XY = kBinSize;
  kld.KLD_binSize_PHI = kBinAngle;
  kld.KLD_epsilon = options.kld_err;
  kld.KLD_delta = 0.5 * std::erfc(options.kld_z / std::sqrt(2.0));
  kld.KLD_minSampleSize = static_cast<unsigned>(options.min_particles);
  kld.KLD_maxSampleSize = static_cast<unsigned>(options.max_particles);
  return kld;
}

mrpt::obs::CActionCollection toAction(const Pose2 & motion, const OdometryOptions & options)
{
  const Eigen::Matrix3d covariance = motionCovariance(motion, options) + kLeastVariance * Eigen::Matrix3d::Identity();
  mrpt::obs::CActionRobotMovement2D movement;
  const mrpt::poses::CPose2D mean(toTPose2D(motion));
  movement.rawOdometryIncrementReading = mean;
  movement.poseChange = mrpt::poses::CPosePDFGaussian::Create(mean, mrpt::math::CMatrixDouble33(covariance));
  if (covariance.determinant() > kMostUncertain) {
    movement.estimationMethod = mrpt::obs::CActionRobotMovement2D::emScan2DMatching;
  }
  mrpt::obs::CActionCollection action;
  action.insert(movement);
  return action;
}

class ParticleLocalizer final : public Localizer
{
public:
  ParticleLocalizer(const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
  : options_(options), origin_(map.geometry.origin), map_(toGridMap(map, options.laser)), random_(options.seed)
  {
    particles_.options.metricMap = map_;
    particles_.options.KLD_params = kldOptions(options);
    filter_.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
    filter_.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prMultinomial;
    filter_.m_options.BETA = 0.0;  // Resampled together with the motion, or not at all.
    const bool averages = options.laser.model == LaserModel::kLikelihoodField;
    power_ = averages ? kAveragePower : 1.0;
    search_power_ = averages ? power_ : std::min(1.0, kIndependentBeams / options.laser.max_beams);
    setPose(start);
  }

  void setPose(const Estimate & estimate) override
  {
    const RandomScope scope(random_);
    mrpt::math::CMatrixDouble33 covariance;
    for (int i = 0; i < 9; ++i) {
      covariance(i / 3, i % 3) = estimate.covariance[i] + (i % 4 == 0 ? kLeastVariance : 0.0);
    }
    mrpt::poses::CPosePDFGaussian belief(mrpt::poses::CPose2D(toTPose2D(estimate.pose)), covariance);
    belief.changeCoordinatesReference(mrpt::poses::CPose3D(mrpt::poses::CPose2D(toTPose2D(inverse(origin_)))));
    set(drawOf(belief, static_cast<std::size_t>(options_.max_particles)));
    believed_ = estimate.pose;
    startAgain();
    if (covariance(0, 0) + covariance(1, 1) > kFound * kFound) {
      lost_.emplace(*map_, drawOf(belief, kPlacesAbout));
    }
  }

  void spreadOut() override
  {
    const auto road = roadAbout(*map_, compose(inverse(origin_), believed_));
    if (road.empty()) {
      throw Error("nothing is free on the map");
    }
    set(drawOn(road, static_cast<std::size_t>(options_.max_particles)));
    startAgain();
    lost_.emplace(*map_, road);
  }

  void updateNext() override { due_ = true; }

  Outcome process(const Scan & scan, const Pose2 & lidar, const Pose2 & odometry) override
  {
    requireUsable(scan);
    Pose2 motion = odometry_ ? compose(inverse(*odometry_), odometry) : Pose2{};
    requireOption(norm(motion.position()) <= kFarthest, "way of odometry", norm(motion.position()), "at most 1e+06");
    if (!due_ && !farEnough(motion)) {
      return Outcome::kIgnored;
    }
    const auto observation = toObservation(scan, lidar, options_.laser);
    if (!observation) {
      return Outcome::kIgnored;
    }
    due_ = false;
    odometry_ = odometry;
    if (lost_ && look(*observation, odometry)) {
      motion = {};
    }
    // Random beams are spread over this range. MRPT remembers likelihoods: only the first scan has a say.
    map_->likelihoodOptions.LF_maxRange = *(max_range_ = max_range_.value_or(observation->maxRange));
    return update(motion, observation);
  }

  Estimate estimate() const override
  {
    std::vector<WeightedPose> weighted;
    weighted.reserve(particles_.size());
    for (const auto & particle : particles_.m_particles) {
      weighted.push_back({toMap(particle.d), std::exp(particle.log_w)});
    }
    Estimate estimate = heaviestCluster(weighted);
    // The particles cannot know that the map is only right to half a cell.
    const double map_variance = std::pow(0.5 * map_->getResolution(), 2);
    estimate.covariance[0] += map_variance;
    estimate.covariance[4] += map_variance;
    if (lost_) {  // It may just as well be somewhere else than most particles.
      const double variance = 0.5 * (spread_(0, 0) + spread_(1, 1));
      estimate.covariance[0] += variance;
      estimate.covariance[4] += variance;
      estimate.covariance[8] += spread_(2, 2);
    }
    return estimate;
  }

  std::vector<Pose2> particles() const override
  {
    std::vector<Pose2> poses;
    poses.reserve(particles_.size());
    for (const auto & particle : particles_.m_particles) {
      poses.push_back(toMap(particle.d));
    }
    return poses;
  }

private:
  // Puts the particles where the car is found. Returns whether it was looked for.
  bool look(const mrpt::obs::CObservation2DRangeScan & observation, const Pose2 & odometry)
  {
    const std::vector<Place> places = lost_->look(observation, odometry);
    if (places.empty()) {
      return false;
    }
    is_searching_ = true;
    std::vector<Pose2> poses;
    double share = 0.0;
    for (const Place & place : places) {
      share += place.fit;
      while (poses.size() + 0.5 < share * options_.max_particles) {
        const double yaw = place.pose.yaw + random_.drawGaussian1D(0.0, kHeadingError);
        const double y = place.pose.y + random_.drawGaussian1D(0.0, kPlaceError);
        poses.push_back({place.pose.x + random_.drawGaussian1D(0.0, kPlaceError), y, yaw});
      }
    }
    set(poses);
    spread_ = std::get<0>(particles_.getCovarianceAndMean());
    if (lost_->isOver()) {
      lost_.reset();
    }
    return true;
  }

  static std::vector<Pose2> drawOf(const mrpt::poses::CPosePDFGaussian & belief, std::size_t count)
  {
    std::vector<mrpt::math::CVectorDouble> samples;
    belief.drawManySamples(count, samples);
    std::vector<Pose2> poses;
    poses.reserve(count);
    for (const auto & sample : samples) {
      poses.push_back({sample[0], sample[1], sample[2]});
    }
    return poses;
  }

  std::vector<Pose2> drawOn(const Points & road, std::size_t count)
  {
    const double half = 0.5 * map_->getResolution();
    std::vector<Pose2> poses;
    poses.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto & cell = road[std::min<std::size_t>(random_.drawUniform(0.0, 1.0) * road.size(), road.size() - 1)];
      const double yaw = random_.drawUniform(-M_PI, M_PI);
      const double y = cell.y + random_.drawUniform(-half, half);
      poses.push_back({cell.x + random_.drawUniform(-half, half), y, yaw});
    }
    return poses;
  }

  void set(const std::vector<Pose2> & poses)
  {
    particles_.m_particles.clear();
    for (const Pose2 & pose : poses) {
      particles_.m_particles.emplace_back(toTPose2D(pose), 0.0);
    }
  }

  // Until the particles have converged.
  bool isSearching()
  {
    if (is_searching_) {
      const auto [covariance, mean] = particles_.getCovarianceAndMean();
      is_searching_ = covariance(0, 0) + covariance(1, 1) > kFound * kFound;
    }
    return is_searching_;
  }

  void startAgain()
  {
    lost_.reset();
    spread_.setZero();
    is_searching_ = false;
    odometry_.reset();
    due_ = true;
    updates_ = 0;
  }

  bool farEnough(const Pose2 & motion) const
  {
    return std::hypot(motion.x, motion.y) > options_.update_min_d || std::abs(motion.yaw) > options_.update_min_a;
  }

  Outcome update(const Pose2 & motion, const mrpt::obs::CObservation2DRangeScan::Ptr & observation)
  {
    const RandomScope scope(random_);
    // MRPT resamples particles by their previous weights while it moves them. The first ones are good as they are.
    filter_.m_options.powFactor = isSearching() ? search_power_ : power_;
    const bool resamples = updates_ > 0 && updates_ % options_.resample_interval == 0;
    ++updates_;
    filter_.m_options.adaptiveSampleSize = resamples;
    const mrpt::obs::CActionCollection action = toAction(motion, options_.odometry);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(observation);
    filter_.executeOn(particles_, &action, &frame);
    return resamples ? Outcome::kResampled : Outcome::kUpdated;
  }

  Pose2 toMap(const mrpt::math::TPose2D & pose) const { return compose(origin_, fromTPose2D(pose)); }

  LocalizerOptions options_;
  Pose2 origin_;  // of MRPT's map, whose frame the particles are in
  mrpt::maps::COccupancyGridMap2D::Ptr map_;
  mrpt::random::CRandomGenerator random_;
  mrpt::slam::CMonteCarloLocalization2D particles_;
  mrpt::bayes::CParticleFilter filter_;
  std::optional<Pose2> odometry_;   // at the last scan that counted
  std::optional<float> max_range_;  // m, of the first scan
  bool due_{true};
  int updates_{0};
  Pose2 believed_;  // where the car was last said to be, in the frame of the map
  std::optional<LostCar> lost_;
  mrpt::math::CMatrixDouble33 spread_;  // covariance of all places at the last look
  bool is_searching_{false};
  double power_{1.0};         // of the likelihood of a scan
  double search_power_{1.0};  // of a car that is lost
};
}  // namespace

std::unique_ptr<Localizer> Localizer::make(
  const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
{
  return std::make_unique<ParticleLocalizer>(map, options, start);
}
}  // namespace amcl
