#include "displays.h"

#include <algorithm>
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
  local_costmap_(private_node, "local_costmap", parameters.local_publish_frequency, parameters.local_always_whole),
  surroundings_(parameters.local_width, parameters.local_height, parameters.local_resolution, parameters.costmap.live)
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
  if (local_costmap_.wanted()) {
    watchSurroundings();
  }
  if (global_costmap_.due(stamp)) {
    showGlobalCostmap(stamp);
  }
  if (local_costmap_.due(stamp)) {
    showLocalCostmap(stamp);
  }
  const std::vector<Vec2> & corners = perception_.costmap().footprint().corners();
  if (Throttled & footprint = global_costmap_.footprint(); footprint.due(stamp)) {
    footprint.publisher.publish(toPolygon(corners, car, headerOf(parameters_.global_frame, stamp)));
  }
  if (Throttled & footprint = local_costmap_.footprint(); footprint.due(stamp)) {
    if (const auto map = mapInLocalFrame()) {
      footprint.publisher.publish(toPolygon(corners, compose(*map, car), headerOf(parameters_.local_frame, stamp)));
    }
  }
}

void Displays::showGlobalCostmap(const ros::Time & stamp)
{
  const Costmap & costmap = perception_.costmap();
  if (map_number_ != perception_.mapNumber()) {
    map_number_ = perception_.mapNumber();
    map_costs_ = inflated(costmap.mapCells(), costmap.geometry(), costmap.inflation());
  }
  OccupancyGrid costs{costmap.geometry(), map_costs_};
  addObstacles(costs, costmap.liveCells(), costmap.inflation());
  global_costmap_.publish(toOccupancyGrid(costs, headerOf(parameters_.global_frame, stamp)));
}

// Every scan counts: what one sees, the next may not.
void Displays::watchSurroundings()
{
  const sensor_msgs::LaserScan::ConstPtr & scan = perception_.latestScan();
  if (!scan || scan == last_scan_) {
    return;
  }
  last_scan_ = scan;
  try {
    surroundings_.moveTo(perception_.poseIn(parameters_.local_frame, parameters_.base_frame).position());
    surroundings_.observe(
      fromLaserScan(*scan, perception_.poseIn(parameters_.local_frame, scan->header.frame_id, scan->header.stamp)));
  } catch (const tf2::TransformException &) {
    // The next scan may have its transforms.
  }
}

void Displays::showLocalCostmap(const ros::Time & stamp)
{
  const GridGeometry & geometry = surroundings_.geometry();
  local_costmap_.publish(toOccupancyGrid(
    {geometry, inflated(surroundings_.cells(), geometry, parameters_.local_inflation)},
    headerOf(parameters_.local_frame, stamp)));
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
