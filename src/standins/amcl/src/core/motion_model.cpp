#include "motion_model.h"

#include <algorithm>
#include <cmath>

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

// @param jacobian  by how much x, y and yaw change with each of the three independent errors
Eigen::Matrix3d propagate(const Eigen::Matrix3d & jacobian, double first, double second, double third)
{
  return jacobian * Eigen::Vector3d(first, second, third).asDiagonal() * jacobian.transpose();
}

// A turn towards the goal, a straight way, a turn into the final heading.
template <class Variance>
Eigen::Matrix3d diffCovariance(const Pose2 & motion, const OdometryOptions & options, Variance variance)
{
  const double way = std::hypot(motion.x, motion.y);
  const double bearing = way < kLeastTranslation ? 0.0 : std::atan2(motion.y, motion.x);
  const double first = turnSquared(bearing);
  const double last = turnSquared(motion.yaw - bearing);
  const double c = std::cos(bearing);
  const double s = std::sin(bearing);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  jacobian(0, 0) = -way * s;
  jacobian(1, 0) = way * c;
  jacobian(0, 1) = c;
  jacobian(1, 1) = s;
  jacobian(2, 0) = jacobian(2, 2) = 1.0;
  return propagate(
    jacobian, variance(options.alpha1 * first + options.alpha2 * square(way)),
    variance(options.alpha3 * square(way) + options.alpha4 * (first + last)),
    variance(options.alpha1 * last + options.alpha2 * square(way)));
}

// A straight way in any direction, while turning.
template <class Variance>
Eigen::Matrix3d omniCovariance(const Pose2 & motion, const OdometryOptions & options, Variance variance)
{
  const double way = square(motion.x) + square(motion.y);
  const double turn = square(motion.yaw);
  const double bearing = std::atan2(motion.y, motion.x);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 0) = jacobian(1, 1) = std::cos(bearing);
  jacobian(1, 0) = std::sin(bearing);
  jacobian(0, 1) = -jacobian(1, 0);
  return propagate(
    jacobian, variance(options.alpha3 * way + options.alpha1 * turn),
    variance(options.alpha1 * turn + options.alpha5 * way), variance(options.alpha4 * turn + options.alpha2 * way));
}
}  // namespace

Eigen::Matrix3d motionCovariance(const Pose2 & motion, const OdometryOptions & options)
{
  const auto of_deviation = [](double term) { return square(term); };
  const auto of_variance = [](double term) { return term; };
  switch (options.model) {
    case OdometryModel::kDiff:
      return diffCovariance(motion, options, of_deviation);
    case OdometryModel::kDiffCorrected:
      return diffCovariance(motion, options, of_variance);
    case OdometryModel::kOmni:
      return omniCovariance(motion, options, of_deviation);
    default:
      return omniCovariance(motion, options, of_variance);
  }
}
}  // namespace amcl
