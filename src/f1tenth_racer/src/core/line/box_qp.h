#pragma once

#include <Eigen/SparseCore>

namespace f1tenth_racer
{
/// min 1/2 x'Hx + g'x with low <= x <= high, H symmetric, positive definite, with all of its diagonal stored.
struct BoxQp
{
  Eigen::SparseMatrix<double> hessian;
  Eigen::VectorXd gradient;
  Eigen::VectorXd low;
  Eigen::VectorXd high;
};

/// The minimum, within the bounds, by a primal-dual interior-point method (Nocedal and Wright 2006, section 16.6). Its
/// number of steps hardly depends on the size of the problem, so that banded problems take time in proportion to theirs.
Eigen::VectorXd solve(const BoxQp & problem);
}  // namespace f1tenth_racer
