#include "line/race_line.h"

#include <algorithm>
#include <cmath>

#include "line/box_qp.h"
#include "line/corridor.h"
#include "line/resample.h"

namespace f1tenth_racer
{
namespace
{
// Each round takes the line of the one before as its reference, because curvature is linearised around that.
constexpr int kRounds = 4;
constexpr int kRepairs = 6;
constexpr double kRepairWay = 0.4;         // m
constexpr double kRepairPart = 0.7;        // of the room, left by a repair
constexpr double kSteeringLength = 1.0;    // m, over which a change of curvature counts like curvature itself
constexpr double kLeastPull = 1e-4;        // towards the reference, so that the problem has one solution
constexpr double kLeastRoom = 1e-5;        // m, around a point that has none: the solver needs an inside
constexpr std::size_t kShortestLine = 12;  // points
constexpr double kBendTolerance = 1.02;    // part of the greatest curvature
constexpr double kLeadsBy = 1.0;           // m, to the side, within which a line passes a pose
constexpr double kClearanceSlack = 0.01;   // m, by which interpolated distances of a place differ

using Triplets = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> build(Eigen::Index rows, Eigen::Index columns, const Triplets & triplets)
{
  Eigen::SparseMatrix<double> matrix(rows, columns);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

// Curvature of the shifted line, linear in the shifts: bend + slope * shift, for all points but the ends.
struct LinearCurvature
{
  Eigen::VectorXd bend;
  Eigen::SparseMatrix<double> slope;
};

LinearCurvature curvatureOf(const Path & line)
{
  const auto count = static_cast<Eigen::Index>(line.size());
  const double step = length(line) / static_cast<double>(count - 1);
  LinearCurvature result;
  result.bend.resize(count - 2);
  Triplets slope;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vec2 normal = leftNormal(line[i].pose);
    const auto row = static_cast<int>(i) - 1;
    result.bend[row] = 0.0;
    for (const std::size_t j : {i - 1, i, i + 1}) {
      const double weight = (j == i ? -2.0 : 1.0) / (step * step);
      result.bend[row] += weight * dot(normal, line[j].pose.position() - line[i].pose.position());
      slope.emplace_back(row, static_cast<int>(j), weight * dot(normal, leftNormal(line[j].pose)));
    }
  }
  result.slope = build(count - 2, count, slope);
  return result;
}

Eigen::SparseMatrix<double> firstDifferences(Eigen::Index count)
{
  Triplets triplets;
  for (int i = 0; i + 1 < count; ++i) {
    triplets.emplace_back(i, i, -1.0);
    triplets.emplace_back(i, i + 1, 1.0);
  }
  return build(count - 1, count, triplets);
}

// What a line passes near to.
struct Gate
{
  Pose2 pose;
  bool by_heading{false};  // held in its heading as well: from when a line has missed it
};

class RaceLine
{
public:
  RaceLine(
    const Path & line, const Costmap & costmap, double clearance, double greatest_curvature,
    const RaceLineOptions & options)
  : line_(line),
    costmap_(costmap),
    clearance_(clearance),
    greatest_curvature_(greatest_curvature),
    options_(options),
    corridor_(corridorAround(line, costmap, clearance, slips(line, options)))
  {
    fixStart();
  }

  // Keeps to the gates in their order, as far as the line passes them: those of a later part of the road may be beside
  // this one. Returns how many these are, at least the first.
  std::size_t hold(std::vector<Gate> & gates)
  {
    std::size_t before = 0;
    for (std::size_t k = 0; k < gates.size(); ++k) {
      Gate & gate = gates[k];
      const std::size_t i = nearestTo(line_, gate.pose);
      const bool led_by = i > before && i + 1 < line_.size() && std::abs(leftOf(i, gate.pose.position())) <= kLeadsBy;
      if (k > 0 && !led_by) {
        return k;
      }
      holdPoint(i, gate.pose.position());
      const double turned = std::abs(normalizeAngle(line_[i].pose.yaw - gate.pose.yaw));
      gate.by_heading = gate.by_heading || turned > options_.gate_yaw_tolerance;
      if (gate.by_heading) {
        holdHeading(i, gate.pose);
      }
      before = i;
    }
    return gates.size();
  }

  bool narrow(const Narrowing & narrowing)
  {
    const bool way_left = narrowing(line_, corridor_);
    fixStart();
    return way_left;
  }

  // Empty when no line that was found keeps the rules.
  Path optimal()
  {
    for (int repair = 0; repair < kRepairs; ++repair) {
      Path path = shifted(shifts());
      if (!narrowWhereBroken(path)) {
        return path;
      }
    }
    return {};
  }

private:
  // How far a place is to the left of the line, m.
  double leftOf(std::size_t i, const Vec2 & place) const
  {
    return dot(place - line_[i].pose.position(), leftNormal(line_[i].pose));
  }

  // Beside a piece of the gate's tangent, as long as its ends let the heading differ by the tolerance.
  void holdHeading(std::size_t nearest, const Pose2 & gate)
  {
    const double reach = options_.gate_tolerance / maths::tan(options_.gate_yaw_tolerance);
    for (std::size_t i = 0; i < line_.size(); ++i) {
      const double along = line_[i].s - line_[nearest].s;
      if (std::abs(along) <= reach) {
        holdPoint(i, advance(gate, along, 0.0).position());
      }
    }
  }

  void holdPoint(std::size_t i, const Vec2 & place)
  {
    const double middle = leftOf(i, place);
    Interval & room = corridor_[i];
    room.low = std::clamp(middle - options_.gate_tolerance, room.low, room.high);
    room.high = std::clamp(middle + options_.gate_tolerance, room.low, room.high);
  }

  void fixStart()
  {
    const double step = length(line_) / static_cast<double>(line_.size() - 1);
    for (std::size_t i = 0; i < kFixedPoints; ++i) {
      const Pose2 wanted = advance(line_.front().pose, static_cast<double>(i) * step, line_.front().curvature);
      const double shift = leftOf(i, wanted.position());
      corridor_[i] = {shift, shift};
    }
  }

  static std::vector<double> slips(const Path & line, const RaceLineOptions & options)
  {
    std::vector<double> result;
    for (const PathPoint & point : line) {
      const double fast = options.max_speed * options.max_speed * point.curvature;
      const double limit = options.lateral_acceleration;
      result.push_back(options.slip_gradient * std::clamp(fast, -limit, limit));
    }
    return result;
  }

  Eigen::VectorXd shifts() const
  {
    const LinearCurvature curvature = curvatureOf(line_);
    const auto count = static_cast<Eigen::Index>(line_.size());
    const double step = length(line_) / static_cast<double>(count - 1);
    const double weight = kSteeringLength * kSteeringLength / (step * step);
    const Eigen::SparseMatrix<double> change = firstDifferences(count - 2);
    const Eigen::SparseMatrix<double> change_slope = change * curvature.slope;
    const Eigen::SparseMatrix<double> transposed = curvature.slope.transpose();
    const Eigen::SparseMatrix<double> change_transposed = change_slope.transpose();
    Eigen::SparseMatrix<double> identity(count, count);
    identity.setIdentity();
    BoxQp problem;
    problem.hessian = transposed * curvature.slope;
    problem.hessian += weight * (change_transposed * change_slope);
    problem.hessian += kLeastPull * identity;
    problem.gradient = transposed * curvature.bend + weight * (change_transposed * (change * curvature.bend));
    problem.low.resize(count);
    problem.high.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Interval & room = corridor_[static_cast<std::size_t>(i)];
      problem.low[i] = room.low - kLeastRoom;
      problem.high[i] = room.high + kLeastRoom;
    }
    return solve(problem);
  }

  Path shifted(const Eigen::VectorXd & shifts) const
  {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      points.push_back(line_[i].pose.position() + shifts[static_cast<Eigen::Index>(i)] * leftNormal(line_[i].pose));
    }
    return pathThrough(points, line_.front());
  }

  bool narrowWhereBroken(const Path & path)
  {
    const std::vector<double> noses = slips(path, options_);
    const double wheels = std::abs(line_.front().curvature);  // may be turned farther than plans turn them
    bool broken = false;
    // The last fixed point is bent by where the next one, which can move, lies.
    for (std::size_t i = kFixedPoints - 1; i < path.size(); ++i) {
      const Pose2 & pose = path[i].pose;
      // Shifts do not change how far the nose is turned: with the same slip the line given counts as close enough.
      const double given = clearanceWithSlip(costmap_, line_[i].pose, noses[i]);
      const double required = std::min(clearance_, given) - kClearanceSlack;
      const bool close = i >= kFixedPoints && clearanceWithSlip(costmap_, pose, noses[i]) < required;
      const double bend_allowed = std::max({greatest_curvature_, std::abs(line_[i].curvature), wheels});
      const bool bent = i + 1 < path.size() && std::abs(path[i].curvature) > kBendTolerance * bend_allowed;
      if (close || bent) {
        narrowAround(line_[i].s);
        broken = true;
      }
    }
    return broken;
  }

  void narrowAround(double s)
  {
    for (std::size_t i = kFixedPoints; i < line_.size(); ++i) {
      if (std::abs(line_[i].s - s) < kRepairWay) {
        Interval & room = corridor_[i];
        const double nearest = std::clamp(0.0, room.low, room.high);
        room.low = nearest + kRepairPart * (room.low - nearest);
        room.high = nearest + kRepairPart * (room.high - nearest);
      }
    }
  }

  const Path & line_;
  const Costmap & costmap_;
  double clearance_;  // m
  double greatest_curvature_;
  const RaceLineOptions & options_;
  std::vector<Interval> corridor_;
};
}  // namespace

Path raceLine(
  const Path & path, const Costmap & costmap, double clearance, const Pose2 & goal, double greatest_curvature,
  const RaceLineOptions & options, const Narrowing & narrowing)
{
  Path line = path;
  std::vector<Gate> gates{{goal}};
  for (const Pose2 & pose : options.goals_beyond) {
    gates.push_back({pose});
  }
  int round = 0;
  while (round < kRounds && line.size() >= kShortestLine) {
    RaceLine problem(line, costmap, clearance, greatest_curvature, options);
    const std::size_t held = problem.hold(gates);
    if (narrowing && !problem.narrow(narrowing)) {
      return {};
    }
    const Path better = problem.optimal();
    if (!better.empty()) {
      line = resampled(better);
      ++round;
    } else if (held > 1) {
      // A line that is still rough may not lead to the last gate as it should, and all would be given up for that.
      gates.resize(held - 1);
    } else {
      return line;
    }
  }
  return line;
}
}  // namespace f1tenth_racer
