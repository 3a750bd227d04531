#include "motion_model.h"

#include <algorithm>

namespace amcl
{
namespace
{
// The direction of a shorter motion is noise.
constexpr double kLeastTranslation = 0.01;  // m

double square(double value)
{
  return value * value;
}

// Driving backwards is no turn.
double turnSquared(double angle)
{
  const double turn = std::abs(normalizeAngle(angle));
  return square(std::min(turn, M_PI - turn));
}
}  // namespace

MotionModel::MotionModel(const Pose2 & motion, const OdometryOptions & options)
: motion_(motion),
  is_omni_(options.model == OdometryModel::kOmni || options.model == OdometryModel::kOmniCorrected),
  way_(norm(motion.position()))
{
  if (is_omni_) {
    errLikeOmni(options);
  } else {
    errLikeDiff(options);
  }
  if (options.model == OdometryModel::kDiffCorrected || options.model == OdometryModel::kOmniCorrected) {
    way_deviation_ = std::sqrt(way_deviation_);
    heading_deviation_ = std::sqrt(heading_deviation_);
    side_deviation_ = std::sqrt(side_deviation_);
  }
}

// A turn towards the goal, a straight way, a turn into the final heading.
void MotionModel::errLikeDiff(const OdometryOptions & options)
{
  bearing_ = way_ < kLeastTranslation ? 0.0 : maths::atan2(motion_.y, motion_.x);
  const double first = turnSquared(bearing_);
  const double last = turnSquared(motion_.yaw - bearing_);
  way_deviation_ = options.alpha3 * square(way_) + options.alpha4 * (first + last);
  heading_deviation_ = options.alpha1 * last + options.alpha2 * square(way_);
  side_deviation_ = options.alpha1 * first + options.alpha2 * square(way_);
}

// A straight way in any direction, while turning.
void MotionModel::errLikeOmni(const OdometryOptions & options)
{
  bearing_ = maths::atan2(motion_.y, motion_.x);
  const double turn = square(motion_.yaw);
  way_deviation_ = options.alpha3 * square(way_) + options.alpha1 * turn;
  heading_deviation_ = options.alpha4 * turn + options.alpha2 * square(way_);
  side_deviation_ = options.alpha1 * turn + options.alpha5 * square(way_);
}

Pose2 MotionModel::sample(const Pose2 & pose, maths::Random & random) const
{
  const double way = way_ + way_deviation_ * random.gaussian();
  const double turn = motion_.yaw + heading_deviation_ * random.gaussian();
  const double aside = side_deviation_ * random.gaussian();
  if (is_omni_) {
    const Vec2 place = transform({pose.x, pose.y, pose.yaw + bearing_}, {way, aside});
    return {place.x, place.y, normalizeAngle(pose.yaw + turn)};
  }
  const Vec2 place = transform({pose.x, pose.y, pose.yaw + bearing_ + aside}, {way, 0.0});
  return {place.x, place.y, normalizeAngle(pose.yaw + aside + turn)};
}
}  // namespace amcl
