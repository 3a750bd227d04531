#include "displays.h"

#include "conversions.h"

namespace move_base
{
namespace
{
std_msgs::Header headerOf(const std::string & frame, const ros::Time & stamp)
{
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = stamp;
  return header;
}
}  // namespace

Displays::Displays(ros::NodeHandle private_node, const MoveBaseParameters & parameters, const Perception & perception)
: parameters_(parameters),
  perception_(perception),
  global_plan_(
    private_node, {"global_plan", parameters.global_planner + "/plan", parameters.local_planner + "/global_plan"},
    true),
  local_plan_(private_node, {"local_plan", parameters.local_planner + "/local_plan"}, false),
  global_costmap_{
    private_node.advertise<nav_msgs::OccupancyGrid>("global_costmap/costmap", 1),
    parameters.global_publish_frequency,
    {}},
  local_costmap_{
    private_node.advertise<nav_msgs::OccupancyGrid>("local_costmap/costmap", 1),
    parameters.local_publish_frequency,
    {}},
  footprint_{
    private_node.advertise<geometry_msgs::PolygonStamped>("local_costmap/footprint", 1),
    parameters.local_publish_frequency,
    {}}
{
}

void Displays::showGlobalPlan(const Path & path, const ros::Time & stamp)
{
  global_plan_.publish(toPath(posesOf(path), headerOf(parameters_.global_frame, stamp)));
}

void Displays::showLocalPlan(const std::vector<Pose2> & prediction, const ros::Time & stamp)
{
  if (prediction.empty() || !local_plan_.wanted()) {
    return;
  }
  if (const auto map = mapInLocalFrame()) {
    std::vector<Pose2> poses;
    for (const Pose2 & pose : prediction) {
      poses.push_back(compose(*map, pose));
    }
    local_plan_.publish(toPath(poses, headerOf(parameters_.local_frame, stamp)));
  }
}

void Displays::showSurroundings(const Pose2 & car, const ros::Time & stamp)
{
  if (global_costmap_.due(stamp)) {
    showGlobalCostmap(stamp);
  }
  if (local_costmap_.due(stamp)) {
    showLocalCostmap(car, stamp);
  }
  if (footprint_.due(stamp)) {
    const auto header = headerOf(parameters_.global_frame, stamp);
    footprint_.publisher.publish(toPolygon(perception_.costmap().footprint().corners(), car, header));
  }
}

bool Displays::Throttled::due(const ros::Time & stamp)
{
  const bool waiting = last && stamp >= *last && (stamp - *last).toSec() * frequency < 1.0;
  if (frequency <= 0.0 || waiting || publisher.getNumSubscribers() == 0) {
    return false;
  }
  last = stamp;
  return true;
}

void Displays::showGlobalCostmap(const ros::Time & stamp)
{
  const GridGeometry & geometry = perception_.costmap().geometry();
  global_costmap_.publisher.publish(toOccupancyGrid(
    perception_.costmap(), {0, 0}, {geometry.width, geometry.height}, {}, headerOf(parameters_.global_frame, stamp)));
}

void Displays::showLocalCostmap(const Pose2 & car, const ros::Time & stamp)
{
  const auto map = mapInLocalFrame();
  if (!map) {
    return;
  }
  const GridGeometry & geometry = perception_.costmap().geometry();
  const Vec2 half{0.5 * parameters_.local_width, 0.5 * parameters_.local_height};
  const Cell from = geometry.cellAt(car.position() - half);
  const Cell to = geometry.cellAt(car.position() + half);
  local_costmap_.publisher.publish(
    toOccupancyGrid(perception_.costmap(), from, to, *map, headerOf(parameters_.local_frame, stamp)));
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
