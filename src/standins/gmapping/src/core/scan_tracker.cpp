#include "scan_tracker.h"

namespace gmapping
{
namespace
{
constexpr double kEveryWay = 0.1;    // m between looks
constexpr double kEveryTurn = 0.06;  // rad
// Wheels slip alike from look to look, and the map of the looks would follow them. What odometry says of a turn hardly
// counts compared with the walls; its way is still needed, as the steps of pixels make ways too long.
constexpr double kSlipAlong = 2.0;  // times the standard deviation of odometry
constexpr double kSlipAside = 10.0;
constexpr double kSlipTurning = 40.0;

MotionNoise whileSlipping(MotionNoise noise)
{
  noise.srr *= kSlipAlong;
  noise.str *= kSlipAside;
  noise.srt *= kSlipTurning;
  noise.stt *= kSlipTurning;
  return noise;
}
}  // namespace

ScanTracker::ScanTracker(const MatcherOptions & matcher, const MotionNoise & odometry)
: matcher_(matcher), noise_(whileSlipping(odometry)), minimum_score_(matcher.minimum_score)
{
}

void ScanTracker::start(const std::vector<Beam> & beams, const Pose2 & pose, double max_urange)
{
  pose_ = pose;
  max_urange_ = max_urange;
  map_.add(beams, pose_, max_urange_);
}

void ScanTracker::drive(const Pose2 & motion)
{
  motion_ = compose(motion_, motion);
  progress_.add(motion);
}

bool ScanTracker::isDue() const
{
  return progress_.distance >= kEveryWay || progress_.turn >= kEveryTurn;
}

void ScanTracker::look(const std::vector<Beam> & beams)
{
  const PoseBelief expected = expectedPose(pose_, motion_, progress_, noise_);
  const std::vector<Vec2> ends = endsOf(beams);
  const PoseBelief matched = matcher_.match(map_.map(), ends, expected);
  const bool fits = matcher_.score(map_.map(), ends, matched.mean) > minimum_score_;
  pose_ = fits ? matched.mean : expected.mean;
  information_.setZero();
  if (fits) {
    information_ = matched.information - expected.information;
  }
  motion_ = {};
  progress_ = {};
  map_.add(beams, pose_, max_urange_);
}
}  // namespace gmapping
