#include "path/path_extension.h"

#include <algorithm>
#include <array>
#include <limits>

namespace move_base
{
namespace
{
constexpr double kExtensionArcLength = 0.3;
constexpr std::array<double, 5> kExtensionSteering{0.0, -0.3, 0.3, -1.0, 1.0};  // parts of the greatest curvature
// Ways kept after each arc; more of them only differ by less than the car's width.
constexpr std::size_t kBeamWidth = 60;

struct Way
{
  Pose2 end;
  double cost;
  std::vector<Arc> arcs;
};

std::vector<Way> grow(
  const std::vector<Way> & ways, const Costmap & costmap, const ClearanceRule & rule, const PlannerOptions & options)
{
  std::vector<Way> grown;
  for (const Way & way : ways) {
    for (const double steering : kExtensionSteering) {
      const Arc arc{kExtensionArcLength, steering / options.min_turning_radius};
      const double price = priceOf(costmap, rule, way.end, arc);
      if (price < std::numeric_limits<double>::infinity()) {
        const double bend = options.curvature_penalty * kExtensionArcLength * std::abs(steering);
        grown.push_back({advance(way.end, arc.length, arc.curvature), way.cost + price + bend, way.arcs});
        grown.back().arcs.push_back(arc);
      }
    }
  }
  std::stable_sort(grown.begin(), grown.end(), [](const Way & a, const Way & b) { return a.cost < b.cost; });
  grown.resize(std::min(grown.size(), kBeamWidth));
  return grown;
}
}  // namespace

std::vector<Arc> extensionFrom(
  const Pose2 & pose, const Costmap & costmap, const ClearanceRule & rule, const PlannerOptions & options,
  double wanted_length)
{
  std::vector<Way> ways{{pose, 0.0, {}}};
  for (double driven = 0.0; driven < wanted_length; driven += kExtensionArcLength) {
    const std::vector<Way> grown = grow(ways, costmap, rule, options);
    if (grown.empty()) {
      break;
    }
    ways = grown;
  }
  return ways.front().arcs;
}
}  // namespace move_base
