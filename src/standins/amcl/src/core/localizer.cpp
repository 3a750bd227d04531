#include "amcl/localizer.h"

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <cmath>
#include <optional>
#include <utility>

#include "amcl/errors.h"
#include "clusters.h"
#include "engine_types.h"
#include "motion_model.h"

namespace amcl
{
namespace
{
// The original sums up cubes of the beams' likelihoods; close to that is the cube of their mean.
constexpr double kAveragePower = 3.0;
constexpr double kLeastFreedom = 0.7;  // probability of a cell to be free in which a car may be
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
  mrpt::obs::CActionCollection action;
  action.insert(movement);
  return action;
}
}  // namespace

class Localizer::Impl
{
public:
  Impl(const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
  : options_(options), origin_(map.geometry.origin), map_(toGridMap(map, options.laser)), random_(options.seed)
  {
    particles_.options.metricMap = map_;
    particles_.options.KLD_params = kldOptions(options);
    filter_.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
    filter_.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prMultinomial;
    filter_.m_options.BETA = 0.0;  // Drawn anew together with the motion, or not at all.
    filter_.m_options.powFactor = options.laser.model == LaserModel::kLikelihoodField ? kAveragePower : 1.0;
    setPose(start);
  }

  void setPose(const Estimate & estimate)
  {
    const RandomScope scope(random_);
    mrpt::math::CMatrixDouble33 covariance;
    for (int i = 0; i < 9; ++i) {
      covariance(i / 3, i % 3) = estimate.covariance[i] + (i % 4 == 0 ? kLeastVariance : 0.0);
    }
    mrpt::poses::CPosePDFGaussian belief(mrpt::poses::CPose2D(toTPose2D(estimate.pose)), covariance);
    belief.changeCoordinatesReference(mrpt::poses::CPose3D(mrpt::poses::CPose2D(toTPose2D(inverse(origin_)))));
    std::vector<mrpt::math::CVectorDouble> samples;
    belief.drawManySamples(static_cast<std::size_t>(options_.max_particles), samples);
    particles_.m_particles.clear();
    for (const auto & sample : samples) {
      particles_.m_particles.emplace_back(mrpt::math::TPose2D(sample[0], sample[1], sample[2]), 0.0);
    }
    startAgain();
  }

  void spreadOut()
  {
    const RandomScope scope(random_);
    try {
      particles_.resetUniformFreeSpace(map_.get(), kLeastFreedom, options_.max_particles);
    } catch (const std::exception &) {
      throw MapError("nothing is free on the map");
    }
    startAgain();
  }

  void updateNext() { due_ = true; }

  Outcome process(const Scan & scan, const Pose2 & lidar, const Pose2 & odometry)
  {
    const Pose2 motion = odometry_ ? compose(inverse(*odometry_), odometry) : Pose2{};
    if (!due_ && !farEnough(motion)) {
      return Outcome::kIgnored;
    }
    const auto observation = toObservation(scan, lidar, options_.laser);
    if (!observation) {
      return Outcome::kIgnored;
    }
    due_ = false;
    odometry_ = odometry;
    // Over this range random beams are spread. MRPT remembers likelihoods: only the first scan has a say.
    map_->likelihoodOptions.LF_maxRange = *(max_range_ = max_range_.value_or(observation->maxRange));
    return update(motion, observation);
  }

  Estimate estimate() const
  {
    std::vector<WeightedPose> weighted;
    weighted.reserve(particles_.size());
    for (const auto & particle : particles_.m_particles) {
      weighted.push_back({toMap(particle.d), std::exp(particle.log_w)});
    }
    return heaviestCluster(weighted);
  }

  std::vector<Pose2> particles() const
  {
    std::vector<Pose2> poses;
    poses.reserve(particles_.size());
    for (const auto & particle : particles_.m_particles) {
      poses.push_back(toMap(particle.d));
    }
    return poses;
  }

private:
  void startAgain()
  {
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
    // MRPT draws particles anew by their weights from before while it moves them. The first ones are good as they are.
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
};

Localizer::Localizer(const OccupancyGrid & map, const LocalizerOptions & options, const Estimate & start)
{
  options.validate();
  impl_ = std::make_unique<Impl>(map, options, start);
}
Localizer::~Localizer() = default;
Localizer::Localizer(Localizer &&) noexcept = default;
Localizer & Localizer::operator=(Localizer &&) noexcept = default;

void Localizer::setPose(const Estimate & estimate)
{
  impl_->setPose(estimate);
}
void Localizer::spreadOut()
{
  impl_->spreadOut();
}
void Localizer::updateNext()
{
  impl_->updateNext();
}
Outcome Localizer::process(const Scan & scan, const Pose2 & lidar, const Pose2 & odometry)
{
  return impl_->process(scan, lidar, odometry);
}
Estimate Localizer::estimate() const
{
  return impl_->estimate();
}
std::vector<Pose2> Localizer::particles() const
{
  return impl_->particles();
}
}  // namespace amcl
