#include "amcl/estimate.h"

#include <workspace_support/option_checks.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace amcl
{
namespace
{
// Less than what Localizer adds, so that it draws from a positive covariance.
constexpr double kRounding = 1e-9;
}  // namespace

void Estimate::validate() const
{
  requireOption(std::isfinite(pose.x), "x", pose.x, "a finite number");
  requireOption(std::isfinite(pose.y), "y", pose.y, "a finite number");
  requireOption(std::isfinite(pose.yaw), "yaw", pose.yaw, "a finite number");
  const Eigen::Map<const Eigen::Matrix3d> matrix(covariance.data());
  const double least =
    matrix.allFinite() ? Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0]
                       : NAN;
  requireOption(least >= -kRounding, "least eigenvalue of the covariance", least, "a number of at least 0");
}
}  // namespace amcl
