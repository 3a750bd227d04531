#include "displays.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "conversions.h"

namespace move_base
{
namespace
{
// Names that are remapped to one topic count once.
std::vector<ros::Publisher> advertisePlans(ros::NodeHandle & node, const std::vector<std::string> & topics)
{
  std::vector<ros::Publisher> publishers;
  std::set<std::string> resolved;
  for (const std::string & topic : topics) {
    if (resolved.insert(node.resolveName(topic)).second) {
      publishers.push_back(node.advertise<nav_msgs::Path>(topic, 1));
    }
  }
  return publishers;
}

bool areWanted(const std::vector<ros::Publisher> & publishers)
{
  return std::any_of(publishers.begin(), publishers.end(), [](auto & each) { return each.getNumSubscribers() > 0; });
}

void publishPlan(const std::vector<ros::Publisher> & publishers, const nav_msgs::Path & plan)
{
  for (const ros::Publisher & publisher : publishers) {
    publisher.publish(plan);
  }
}
}  // namespace

Displays::Displays(ros::NodeHandle private_node, const MoveBaseParameters & parameters, const Perception & perception)
: parameters_(parameters),
  perception_(perception),
  global_plan_(advertisePlans(
    private_node, {"global_plan", parameters.global_planner + "/plan", parameters.local_planner + "/global_plan"})),
  local_plan_(advertisePlans(private_node, {"local_plan", parameters.local_planner + "/local_plan"})),
  global_costmap_(private_node, "global_costmap", parameters.global_publish_frequency, parameters.global_always_whole),
  local_costmap_(private_node, "local_costmap", parameters.local_publish_frequency, parameters.local_always_whole)
{
}

void Displays::showGlobalPlan(const Path & path, const ros::Time & stamp)
{
  publishPlan(global_plan_, toPath(posesOf(path), headerOf(parameters_.global_frame, stamp)));
}

void Displays::showLocalPlan(const std::vector<Pose2> & prediction, const ros::Time & stamp)
{
  if (prediction.empty() || !areWanted(local_plan_)) {
    return;
  }
  if (const auto map = mapInLocalFrame()) {
    std::vector<Pose2> poses;
    poses.reserve(prediction.size());
    for (const Pose2 & pose : prediction) {
      poses.push_back(compose(*map, pose));
    }
    publishPlan(local_plan_, toPath(poses, headerOf(parameters_.local_frame, stamp)));
  }
}

void Displays::showSurroundings(const Pose2 & car, const ros::Time & stamp)
{
  if (global_costmap_.due(stamp)) {
    showGlobalCostmap(stamp);
  }
  const std::vector<Vec2> & corners = perception_.costmap().footprint().corners();
  if (Throttled & footprint = global_costmap_.footprint(); footprint.due(stamp)) {
    footprint.publisher.publish(toPolygon(corners, car, headerOf(parameters_.global_frame, stamp)));
  }
  const auto map = mapInLocalFrame();
  if (map && local_costmap_.due(stamp)) {
    showLocalCostmap(compose(*map, car), *map, stamp);
  }
  if (Throttled & footprint = local_costmap_.footprint(); map && footprint.due(stamp)) {
    footprint.publisher.publish(toPolygon(corners, compose(*map, car), headerOf(parameters_.local_frame, stamp)));
  }
}

void Displays::showGlobalCostmap(const ros::Time & stamp)
{
  const Costmap & costmap = perception_.costmap();
  OccupancyGrid costs{costmap.geometry(), {}};
  for (std::size_t i = 0; i < costs.geometry.size(); ++i) {
    costs.cells.push_back(costmap.shownCost(i));
  }
  global_costmap_.publish(toOccupancyGrid(costs, headerOf(parameters_.global_frame, stamp)));
}

// The same around the car, which is in the middle to within a cell.
void Displays::showLocalCostmap(const Pose2 & car, const Pose2 & map, const ros::Time & stamp)
{
  const double cell = parameters_.local_resolution;
  const auto cells = [&](double length) { return std::max(1, static_cast<int>(length / cell + 1e-6)); };
  OccupancyGrid costs{{cells(parameters_.local_width), cells(parameters_.local_height), cell, {}}, {}};
  GridGeometry & window = costs.geometry;
  window.origin = {
    std::round(car.x / cell - 0.5 * window.width) * cell, std::round(car.y / cell - 0.5 * window.height) * cell, 0.0};
  const Costmap & costmap = perception_.costmap();
  const GridGeometry & whole = costmap.geometry();
  const Pose2 local = inverse(map);
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Cell there = whole.cellAt(transform(local, window.centre(window.cell(i))));
    costs.cells.push_back(whole.contains(there) ? costmap.shownCost(whole.index(there)) : std::int8_t{-1});
  }
  local_costmap_.publish(toOccupancyGrid(costs, headerOf(parameters_.local_frame, stamp)));
}

std::optional<Pose2> Displays::mapInLocalFrame() const
{
  try {
    return perception_.poseIn(parameters_.local_frame, parameters_.global_frame);
  } catch (const tf2::TransformException &) {
    return std::nullopt;
  }
}
}  // namespace move_base
