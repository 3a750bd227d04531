#include "line/path_smoother.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <vector>

namespace f1tenth_racer
{
namespace
{
// Prices of bending and of steering, in metres of free road: for a metre of curvature 1/m, and for a metre in which
// the curvature changes by 1/m.
constexpr double kBendingPrice = 0.5;
constexpr double kSteeringPrice = 0.1;
constexpr double kPinStiffness = 1e4;
constexpr int kIterations = 60;
// Where the band breaks the rules, it is pinned to the path as given this far around, and relaxed again.
constexpr double kRepairReach = 0.5;  // m
constexpr int kRepairRounds = 5;
// Three-point curvature of an exact arc differs from the arc's by less than this part.
constexpr double kCurvatureTolerance = 1.01;
constexpr std::size_t kFewestPoints = 7;

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

// The n-th differences of count values, as a matrix.
Matrix differences(int count, const std::vector<double> & stencil)
{
  const int rows = count - static_cast<int>(stencil.size()) + 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < static_cast<int>(stencil.size()); ++i) {
      entries.emplace_back(row, row + i, stencil[static_cast<std::size_t>(i)]);
    }
  }
  Matrix matrix(rows, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// How the cost of being near obstacles changes with x and y, 1/m: differences over a cell.
Vec2 proximityGradient(const Costmap & costmap, const Pose2 & base)
{
  const double h = 0.5 * costmap.geometry().resolution;
  if (costmap.isFarFromAll(base, h)) {
    return {};
  }
  const auto cost = [&](double x, double y) { return costmap.proximityCost(costmap.clearance({x, y, base.yaw})); };
  return {
    (cost(base.x + h, base.y) - cost(base.x - h, base.y)) / (2.0 * h),
    (cost(base.x, base.y + h) - cost(base.x, base.y - h)) / (2.0 * h)};
}

class Band
{
public:
  Band(const Path & given, const Costmap & costmap, const ClearanceRule & rule, double pinned_s)
  : costmap_(costmap),
    rule_(rule),
    given_(given),
    pinned_(given_.size(), false),
    spacing_(length(given_) / static_cast<double>(given_.size() - 1))
  {
    pinAround(given_.front().s, 1.5 * spacing_);
    pinAround(given_.back().s, 1.5 * spacing_);
    pinAround(pinned_s, 1.5 * spacing_);
  }

  Path relaxed(double greatest_curvature)
  {
    for (int round = 0; round < kRepairRounds; ++round) {
      const Path path = asPath(relax());
      if (!pinWhereBroken(path, greatest_curvature)) {
        return path;
      }
    }
    return given_;
  }

private:
  void pinAround(double s, double reach)
  {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      pinned_[i] = pinned_[i] || std::abs(given_[i].s - s) <= reach;
    }
  }

  std::vector<Vec2> relax() const
  {
    const auto count = static_cast<int>(given_.size());
    const Matrix bending = differences(count, {1.0, -2.0, 1.0});
    const Matrix steering = differences(count, {-1.0, 3.0, -3.0, 1.0});
    // The obstacles' cost is stepped explicitly: the inertia must exceed its greatest second derivative.
    const double scaling = costmap_.options().cost_scaling_factor;
    const double inertia = spacing_ * Costmap::kTouchingPrice * scaling * scaling + 1e-3;
    Matrix system = stiffnessUnit(kBendingPrice, 3) * Matrix(bending.transpose() * bending) +
                    stiffnessUnit(kSteeringPrice, 5) * Matrix(steering.transpose() * steering);
    Vector stiffness(count);
    for (int i = 0; i < count; ++i) {
      stiffness[i] = inertia + (pinned_[static_cast<std::size_t>(i)] ? pull() : 0.0);
    }
    system.diagonal() += stiffness;
    const Eigen::SimplicialLDLT<Matrix> solver(system);
    std::vector<Vec2> points(given_.size());
    std::transform(given_.begin(), given_.end(), points.begin(), [](auto & point) { return point.pose.position(); });
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      points = step(points, solver, inertia);
    }
    return points;
  }

  double stiffnessUnit(double price, int power) const
  {
    double unit = 2.0 * price;
    for (int i = 0; i < power; ++i) {
      unit /= spacing_;
    }
    return unit;
  }
  double pull() const { return kPinStiffness * stiffnessUnit(kSteeringPrice, 5); }

  std::vector<Vec2> step(
    const std::vector<Vec2> & points, const Eigen::SimplicialLDLT<Matrix> & solver, double inertia) const
  {
    Vector x(points.size());
    Vector y(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const double back = pinned_[i] ? pull() : 0.0;
      const Vec2 push = pinned_[i] ? Vec2{} : spacing_ * proximityGradient(costmap_, headed(points, i));
      x[row] = inertia * points[i].x - push.x + back * given_[i].pose.x;
      y[row] = inertia * points[i].y - push.y + back * given_[i].pose.y;
    }
    const Vector new_x = solver.solve(x);
    const Vector new_y = solver.solve(y);
    std::vector<Vec2> moved(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      moved[i] = {new_x[static_cast<Eigen::Index>(i)], new_y[static_cast<Eigen::Index>(i)]};
    }
    return moved;
  }

  Pose2 headed(const std::vector<Vec2> & points, std::size_t i) const
  {
    if (i == 0 || i + 1 == points.size()) {
      return given_[i].pose;
    }
    const Vec2 along = points[i + 1] - points[i - 1];
    const double motion = maths::atan2(along.y, along.x);
    return {points[i].x, points[i].y, given_[i].reverse ? normalizeAngle(motion + M_PI) : motion};
  }

  Path asPath(const std::vector<Vec2> & points) const
  {
    Path path = given_;
    for (std::size_t i = 1; i < points.size(); ++i) {
      path[i].pose = headed(points, i);
      path[i].s = path[i - 1].s + distance(points[i - 1], points[i]);
      if (i + 1 < points.size()) {
        const double bend = curvatureThrough(points[i - 1], points[i], points[i + 1]);
        path[i].curvature = path[i].reverse ? -bend : bend;
      }
    }
    path.front().curvature = path[1].curvature;
    path.back().curvature = path[path.size() - 2].curvature;
    return path;
  }

  bool pinWhereBroken(const Path & path, double greatest_curvature)
  {
    bool broken = false;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (pinned_[i] && path[i].curvature == given_[i].curvature) {
        continue;
      }
      const bool bent = std::abs(path[i].curvature) > kCurvatureTolerance * greatest_curvature;
      const double clearance = costmap_.clearance(path[i].pose);
      const bool close = clearance < std::min(rule_.at(path[i].pose.position()), costmap_.clearance(given_[i].pose));
      if (bent || close) {
        pinAround(given_[i].s, kRepairReach);
        broken = true;
      }
    }
    return broken;
  }

  const Costmap & costmap_;
  const ClearanceRule & rule_;
  Path given_;
  std::vector<bool> pinned_;
  double spacing_;
};
}  // namespace

Path smoothPath(
  const Path & path, const Costmap & costmap, const ClearanceRule & rule, double greatest_curvature, double pinned_s)
{
  Path smooth;
  for (const PathStretch & stretch : stretches(path)) {
    Path part(
      path.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
      path.begin() + static_cast<std::ptrdiff_t>(stretch.end));
    if (part.size() >= kFewestPoints) {
      part = Band(part, costmap, rule, pinned_s).relaxed(greatest_curvature);
    }
    const double shift = (smooth.empty() ? 0.0 : smooth.back().s) - part.front().s;
    for (PathPoint & point : part) {
      point.s += shift;
      smooth.push_back(point);
    }
  }
  return smooth;
}
}  // namespace f1tenth_racer
