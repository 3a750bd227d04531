#include "pose_graph.h"

#include <ceres/ceres.h>
#include <workspace_support/maths/exponential.h>
#include <workspace_support/maths/trigonometry.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace gmapping
{
namespace
{
constexpr int kMostIterations = 50;
// In standard deviations: loops that are off by more count less.
constexpr double kTolerance = 2.0;

// Ceres differentiates by computing with jets.
template <int N>
using Jet = ceres::Jet<double, N>;

double cosineOf(double angle)
{
  return maths::cos(angle);
}
double sineOf(double angle)
{
  return maths::sin(angle);
}
double wholeTurnsOf(double angle)
{
  return angle - normalizeAngle(angle);
}
template <int N>
Jet<N> cosineOf(const Jet<N> & angle)
{
  return {maths::cos(angle.a), -maths::sin(angle.a) * angle.v};
}
template <int N>
Jet<N> sineOf(const Jet<N> & angle)
{
  return {maths::sin(angle.a), maths::cos(angle.a) * angle.v};
}
template <int N>
double wholeTurnsOf(const Jet<N> & angle)
{
  return wholeTurnsOf(angle.a);
}

/// Ceres's CauchyLoss, whose logarithm is the C library's.
class LoopLoss final : public ceres::LossFunction
{
public:
  void Evaluate(double square, double * values) const override
  {
    constexpr double kSquare = kTolerance * kTolerance;
    const double inverse = 1.0 / (1.0 + square / kSquare);
    values[0] = kSquare * maths::log(1.0 + square / kSquare);
    values[1] = inverse;
    values[2] = -inverse * inverse / kSquare;
  }
};

/// Difference between where an edge says that a pose is and where it is, in standard deviations.
class EdgeError
{
public:
  explicit EdgeError(const PoseEdge & edge) : relative_(edge.relative), root_(edge.information.llt().matrixU()) {}

  template <class T>
  bool operator()(const T * from, const T * to, T * residuals) const
  {
    const T c = cosineOf(from[2]);
    const T s = sineOf(from[2]);
    const T dx = to[0] - from[0];
    const T dy = to[1] - from[1];
    const T turn = to[2] - from[2] - relative_.yaw;
    Eigen::Matrix<T, 3, 1> difference;
    difference << c * dx + s * dy - relative_.x, c * dy - s * dx - relative_.y, turn - T(wholeTurnsOf(turn));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> result(residuals);
    result = root_.cast<T>() * difference;
    return true;
  }

private:
  Pose2 relative_;
  Eigen::Matrix3d root_;
};

ceres::Solver::Options solverOptions()
{
  ceres::Solver::Options options;
  // Without BLAS, on one thread: the same poses to the last bit every time.
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = kMostIterations;
  options.logging_type = ceres::SILENT;
  return options;
}
}  // namespace

void PoseGraph::keepFirm()
{
  const auto is_loose = [](const PoseEdge & edge) { return !edge.is_firm; };
  edges_.erase(std::remove_if(edges_.begin(), edges_.end(), is_loose), edges_.end());
}

void PoseGraph::optimize()
{
  std::vector<std::array<double, 3>> values;
  values.reserve(poses_.size());
  for (const Pose2 & pose : poses_) {
    values.push_back({pose.x, pose.y, pose.yaw});
  }
  ceres::Problem problem;
  for (const PoseEdge & edge : edges_) {
    auto * cost = new ceres::AutoDiffCostFunction<EdgeError, 3, 3, 3>(new EdgeError(edge));
    ceres::LossFunction * loss = edge.is_loop ? new LoopLoss : nullptr;
    problem.AddResidualBlock(cost, loss, values[edge.from].data(), values[edge.to].data());
  }
  problem.SetParameterBlockConstant(values.front().data());
  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions(), &problem, &summary);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    poses_[i] = {values[i][0], values[i][1], normalizeAngle(values[i][2])};
  }
}
}  // namespace gmapping
