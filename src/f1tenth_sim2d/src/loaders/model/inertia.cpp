#include "loaders/model/inertia.h"

#include <Eigen/Eigenvalues>

namespace f1tenth_sim2d
{
namespace
{
/// Moments of inertia of a point mass about a point that is away from it.
Eigen::Matrix3d momentsOfPoint(double mass, const Eigen::Vector3d & away)
{
  return mass * (away.squaredNorm() * Eigen::Matrix3d::Identity() - away * away.transpose());
}
}  // namespace

bool Inertia::isPossible() const
{
  if (!(mass > 0.0) || !moments.allFinite()) {
    return false;
  }
  const Eigen::Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvalues();
  const double tolerance = 1e-6 * principal[2];
  return principal[0] > -tolerance && principal[2] > 0.0 && principal[0] + principal[1] > principal[2] - tolerance;
}

Eigen::Matrix3d symmetric(double xx, double yy, double zz, double xy, double xz, double yz)
{
  Eigen::Matrix3d matrix;
  matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return matrix;
}

Inertia placed(const Inertia & inertia, const Pose3 & pose)
{
  const Eigen::Matrix3d turned = pose.rotation.toRotationMatrix();
  return {inertia.mass, pose * inertia.centre, turned * inertia.moments * turned.transpose()};
}

Inertia operator+(const Inertia & a, const Inertia & b)
{
  const double mass = a.mass + b.mass;
  if (mass == 0.0) {
    return {0.0, a.centre, a.moments + b.moments};
  }
  const Eigen::Vector3d centre = (a.mass * a.centre + b.mass * b.centre) / mass;
  return {
    mass, centre,
    a.moments + momentsOfPoint(a.mass, a.centre - centre) + b.moments + momentsOfPoint(b.mass, b.centre - centre)};
}
}  // namespace f1tenth_sim2d
