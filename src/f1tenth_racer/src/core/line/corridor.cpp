#include "line/corridor.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kWidest = 1.5;      // m, to either side
constexpr double kWidthStep = 0.04;  // m
// Shifted to the inside of a bend, the path must not come near the centre of the bend.
constexpr double kRadiusPart = 0.7;

double roomTo(double side, const PathPoint & point, double slip, const Costmap & costmap, double clearance)
{
  const Vec2 left = leftNormal(point.pose);
  const bool inside = side * point.curvature > 0.0;
  const double widest = inside ? std::min(kWidest, kRadiusPart / std::abs(point.curvature)) : kWidest;
  const double required = std::min(clearance, clearanceWithSlip(costmap, point.pose, slip));
  double room = 0.0;
  for (double shift = kWidthStep; shift <= widest; shift += kWidthStep) {
    const Vec2 at = point.pose.position() + side * shift * left;
    if (clearanceWithSlip(costmap, {at.x, at.y, point.pose.yaw}, slip) < required) {
      break;
    }
    room = shift;
  }
  return room;
}
}  // namespace

double clearanceWithSlip(const Costmap & costmap, const Pose2 & pose, double slip)
{
  const double straight = costmap.clearance(pose);
  return slip == 0.0 ? straight : std::min(straight, costmap.clearance({pose.x, pose.y, pose.yaw + slip}));
}

std::vector<Interval> corridorAround(
  const Path & path, const Costmap & costmap, double clearance, const std::vector<double> & slips)
{
  std::vector<Interval> corridor;
  for (std::size_t i = 0; i < path.size(); ++i) {
    corridor.push_back(
      {-roomTo(-1.0, path[i], slips[i], costmap, clearance), roomTo(1.0, path[i], slips[i], costmap, clearance)});
  }
  return corridor;
}
}  // namespace f1tenth_racer
