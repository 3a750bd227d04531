#include "motion.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

namespace gmapping
{
namespace
{
// Without any motion odometry is right to this, so that no standard deviation is 0.
constexpr double kLeastTranslation = 1e-4;  // m
constexpr double kLeastRotation = 1e-4;     // rad
// Sideways error of a translation over the error along it.
constexpr double kSideways = 0.3;
}  // namespace

void Progress::add(const Pose2 & motion)
{
  distance += maths::hypot(motion.x, motion.y);
  turn += std::abs(motion.yaw);
}

PoseBelief expectedPose(const Pose2 & pose, const Pose2 & motion, const Progress & progress, const MotionNoise & noise)
{
  const double along = kLeastTranslation + noise.srr * progress.distance;
  const double aside = kLeastTranslation + kSideways * noise.srr * progress.distance + noise.str * progress.turn;
  const double rotation = kLeastRotation + noise.srt * progress.distance + noise.stt * progress.turn;
  const Eigen::Vector3d deviations(along, aside, rotation);
  // The errors are along and across the way, which bends by half the turn on average.
  const Eigen::Matrix3d turned = turnMatrix(pose.yaw + 0.5 * motion.yaw);
  return {compose(pose, motion), turned * deviations.cwiseAbs2().cwiseInverse().asDiagonal() * turned.transpose()};
}
}  // namespace gmapping
