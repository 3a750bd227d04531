#include "line/path_extension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

namespace f1tenth_racer
{
namespace
{
constexpr double kExtensionArcLength = 0.3;
constexpr std::array<double, 5> kExtensionSteering{0.0, -0.3, 0.3, -1.0, 1.0};  // parts of the greatest curvature
constexpr double kBendPrice = 0.1;       // of a metre at the least radius, in metres of free road on top
constexpr std::size_t kBeamWidth = 100;  // ways kept after each arc
// Of ways that end this near to each other only the cheapest is kept: else all may lead into the same dead end.
constexpr double kCell = 0.3;         // m
constexpr double kCellHeading = 0.3;  // rad

struct Candidate
{
  Pose2 end;
  double cost;
  std::vector<Arc> arcs;
};

using EndCell = std::tuple<long, long, long>;

EndCell cellOf(const Pose2 & pose)
{
  return {std::lround(pose.x / kCell), std::lround(pose.y / kCell), std::lround(pose.yaw / kCellHeading)};
}

// The cheapest ways first, one from each cell.
std::vector<Candidate> best(std::vector<Candidate> ways)
{
  std::stable_sort(ways.begin(), ways.end(), [](const Candidate & a, const Candidate & b) { return a.cost < b.cost; });
  std::vector<Candidate> kept;
  std::set<EndCell> taken;
  for (Candidate & way : ways) {
    if (kept.size() < kBeamWidth && taken.insert(cellOf(way.end)).second) {
      kept.push_back(std::move(way));
    }
  }
  return kept;
}

std::vector<Candidate> grow(
  const std::vector<Candidate> & ways, const Costmap & costmap, const ClearanceRule & rule,
  const PlannerOptions & options)
{
  std::vector<Candidate> grown;
  for (const Candidate & way : ways) {
    for (const double steering : kExtensionSteering) {
      const Arc arc{kExtensionArcLength, steering / options.min_turning_radius};
      const double price = priceOf(costmap, rule, way.end, arc);
      if (price < std::numeric_limits<double>::infinity()) {
        const double bend = kBendPrice * kExtensionArcLength * std::abs(steering);
        grown.push_back({advance(way.end, arc.length, arc.curvature), way.cost + price + bend, way.arcs});
        grown.back().arcs.push_back(arc);
      }
    }
  }
  return best(std::move(grown));
}
}  // namespace

std::vector<Arc> extensionFrom(
  const Pose2 & pose, const Costmap & costmap, const ClearanceRule & rule, const PlannerOptions & options,
  double wanted_length)
{
  std::vector<Candidate> ways{{pose, 0.0, {}}};
  for (double driven = 0.0; driven < wanted_length; driven += kExtensionArcLength) {
    std::vector<Candidate> grown = grow(ways, costmap, rule, options);
    if (grown.empty()) {
      break;
    }
    ways = std::move(grown);
  }
  return ways.front().arcs;
}
}  // namespace f1tenth_racer
