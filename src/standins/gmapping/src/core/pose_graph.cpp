#include "pose_graph.h"

#include <ceres/ceres.h>

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

/// Difference between where an edge says that a pose is and where it is, in standard deviations.
class EdgeError
{
public:
  explicit EdgeError(const PoseEdge & edge) : relative_(edge.relative), root_(edge.information.llt().matrixU()) {}

  template <class T>
  bool operator()(const T * from, const T * to, T * residuals) const
  {
    const T c = ceres::cos(from[2]);
    const T s = ceres::sin(from[2]);
    const T dx = to[0] - from[0];
    const T dy = to[1] - from[1];
    const T turn = to[2] - from[2] - relative_.yaw;
    Eigen::Matrix<T, 3, 1> difference;
    difference << c * dx + s * dy - relative_.x, c * dy - s * dx - relative_.y, ceres::atan2(sin(turn), cos(turn));
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
    ceres::LossFunction * loss = edge.is_loop ? new ceres::CauchyLoss(kTolerance) : nullptr;
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
