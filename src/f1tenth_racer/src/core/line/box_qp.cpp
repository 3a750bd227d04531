#include "line/box_qp.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace f1tenth_racer
{
namespace
{
using Array = Eigen::ArrayXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr int kMostSteps = 60;
constexpr double kCentring = 0.15;      // share of the complementarity that a step aims at
constexpr double kBoundaryPart = 0.99;  // of the way to the nearest bound
constexpr double kPrecision = 1e-8;     // of slope and complementarity, in parts of the greatest slope in the middle

// Greatest part of a step within which values stay above 0.
double longestStep(const Array & values, const Array & change)
{
  double part = 1.0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (change[i] < 0.0) {
      part = std::min(part, -kBoundaryPart * values[i] / change[i]);
    }
  }
  return part;
}

class InteriorPoint
{
public:
  /// @param problem  with low < high
  explicit InteriorPoint(const BoxQp & problem)
  : problem_(problem),
    x_(0.5 * (problem.low + problem.high)),
    scale_((problem.hessian * x_.matrix() + problem.gradient).cwiseAbs().maxCoeff()),
    low_price_(Array::Constant(x_.size(), scale_)),
    high_price_(low_price_),
    system_(problem.hessian)
  {
    solver_.analyzePattern(system_);
  }

  Eigen::VectorXd run()
  {
    for (int i = 0; i < kMostSteps && scale_ > 0.0 && !step(); ++i) {
    }
    return x_;
  }

private:
  // @return whether the minimum has been reached
  bool step()
  {
    const Array low_room = x_ - problem_.low.array();
    const Array high_room = problem_.high.array() - x_;
    const Array slope = (problem_.hessian * x_.matrix() + problem_.gradient).array() - low_price_ + high_price_;
    const double gap = ((low_room * low_price_).mean() + (high_room * high_price_).mean()) / 2.0;
    if (gap < kPrecision * scale_ && slope.abs().maxCoeff() < kPrecision * scale_) {
      return true;
    }
    const Array low_pull = kCentring * gap / low_room - low_price_;
    const Array high_pull = kCentring * gap / high_room - high_price_;
    factorize(low_price_ / low_room + high_price_ / high_room);
    const Array change = solver_.solve((low_pull - high_pull - slope).matrix()).array();
    const Array low_change = low_pull - low_price_ / low_room * change;
    const Array high_change = high_pull + high_price_ / high_room * change;
    const double part = std::min(
      {longestStep(low_room, change), longestStep(high_room, -change), longestStep(low_price_, low_change),
       longestStep(high_price_, high_change)});
    x_ += part * change;
    low_price_ += part * low_change;
    high_price_ += part * high_change;
    return false;
  }

  void factorize(const Array & barrier)
  {
    system_ = problem_.hessian;
    system_.diagonal() += barrier.matrix();
    solver_.factorize(system_);
  }

  const BoxQp & problem_;
  Array x_;
  double scale_;
  Array low_price_;  // of moving the bound, positive
  Array high_price_;
  SparseMatrix system_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> solver_;
};
}  // namespace

Eigen::VectorXd solve(const BoxQp & problem)
{
  return InteriorPoint(problem).run();
}
}  // namespace f1tenth_racer
