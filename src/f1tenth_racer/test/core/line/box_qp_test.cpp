#include "line/box_qp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace f1tenth_racer
{
namespace
{
// A beam on springs: the bending of count points, and a pull towards 0.
BoxQp beam(int count, double pull)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 1; i + 1 < count; ++i) {
    entries.emplace_back(i - 1, i - 1, 1.0);
    entries.emplace_back(i - 1, i, -2.0);
    entries.emplace_back(i - 1, i + 1, 1.0);
  }
  Eigen::SparseMatrix<double> bending(count - 2, count);
  bending.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseMatrix<double> identity(count, count);
  identity.setIdentity();
  BoxQp problem;
  problem.hessian = Eigen::SparseMatrix<double>(bending.transpose()) * bending;
  problem.hessian += pull * identity;
  problem.gradient = Eigen::VectorXd::Zero(count);
  problem.low = Eigen::VectorXd::Constant(count, -1.0);
  problem.high = Eigen::VectorXd::Constant(count, 1.0);
  return problem;
}

// How far the solution is from being the minimum: what could be won, to first order, by moving one variable.
double error(const BoxQp & problem, const Eigen::VectorXd & x)
{
  const Eigen::VectorXd slope = problem.hessian * x + problem.gradient;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    worst = std::max({worst, slope[i] * (x[i] - problem.low[i]), -slope[i] * (problem.high[i] - x[i])});
  }
  return worst;
}

TEST(BoxQp, isTheLinearSolutionWhereNoBoundHolds)
{
  BoxQp problem = beam(30, 0.1);
  for (int i = 0; i < 30; ++i) {
    problem.gradient[i] = 0.02 * std::sin(i);
  }
  const Eigen::VectorXd x = solve(problem);
  EXPECT_LT((problem.hessian * x + problem.gradient).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(BoxQp, findsTheMinimumWhereBoundsHold)
{
  BoxQp problem = beam(300, 1e-6);
  for (int i = 0; i < 300; ++i) {
    problem.gradient[i] = 0.05 * std::sin(0.11 * i) + 0.02 * std::cos(0.37 * i);
  }
  const Eigen::VectorXd x = solve(problem);
  EXPECT_LT(error(problem, x), 1e-6);
  EXPECT_LE(x.maxCoeff(), 1.0);
  EXPECT_GE(x.minCoeff(), -1.0);
  EXPECT_GT(x.maxCoeff(), 0.999) << "some bound holds";
}

TEST(BoxQp, keepsWhatHasHardlyAnyRoom)
{
  BoxQp problem = beam(50, 1e-4);
  problem.low[20] = 0.5 - 1e-5;
  problem.high[20] = 0.5 + 1e-5;
  const Eigen::VectorXd x = solve(problem);
  EXPECT_NEAR(x[20], 0.5, 1e-5);
  EXPECT_LT(error(problem, x), 1e-6);
}
}  // namespace
}  // namespace f1tenth_racer
