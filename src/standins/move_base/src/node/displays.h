#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <vector>

#include "costmap_publisher.h"
#include "move_base/path/path.h"
#include "parameters.h"
#include "perception.h"

namespace move_base
{
/// Publishes what a person wants to see: plans, costmaps, footprint. No decision depends on it.
class Displays
{
public:
  Displays(ros::NodeHandle private_node, const MoveBaseParameters & parameters, const Perception & perception);

  void showGlobalPlan(const Path & path, const ros::Time & stamp);
  void showLocalPlan(const std::vector<Pose2> & prediction, const ros::Time & stamp);
  /// Costmaps and footprints, as far as anybody looks and their time has come.
  void showSurroundings(const Pose2 & car, const ros::Time & stamp);

private:
  void showGlobalCostmap(const ros::Time & stamp);
  void showLocalCostmap(const Pose2 & car, const Pose2 & map, const ros::Time & stamp);
  /// Pose of the map in the local frame, or nothing while the transform is missing.
  std::optional<Pose2> mapInLocalFrame() const;

  const MoveBaseParameters & parameters_;
  const Perception & perception_;
  std::vector<ros::Publisher> global_plan_;  // the originals' planners have names of their own
  std::vector<ros::Publisher> local_plan_;
  CostmapPublisher global_costmap_;
  CostmapPublisher local_costmap_;
};
}  // namespace move_base
