#include <workspace_support/parameter_reader.h>

#include <boost/algorithm/string/predicate.hpp>
#include <sstream>

#include "parameters.h"

namespace move_base
{
namespace
{
// Where a parameter of a costmap is: its own place, and, for short, right under the node.
std::vector<std::string> ofCostmap(const std::string & costmap, const std::string & name)
{
  return {costmap + "/" + name, name};
}

// The layers of a costmap, by the names that `plugins` gives them.
class Layers
{
public:
  Layers(ParameterReader & reader, const std::string & costmap) : costmap_(costmap)
  {
    std::vector<PluginName> plugins;
    reader.read(costmap + "/plugins", plugins);
    for (const auto & [name, type] : plugins) {
      if (boost::algorithm::ends_with(type, "StaticLayer")) {
        static_ = name;
      } else if (
        boost::algorithm::ends_with(type, "ObstacleLayer") || boost::algorithm::ends_with(type, "VoxelLayer")) {
        obstacle_ = name;
      } else if (boost::algorithm::ends_with(type, "InflationLayer")) {
        inflation_ = name;
      }
    }
  }

  std::vector<std::string> ofStatic(const std::string & name) const { return in(static_, name); }
  std::vector<std::string> ofObstacle(const std::string & name) const { return in(obstacle_, name); }
  std::vector<std::string> ofInflation(const std::string & name) const { return in(inflation_, name); }

private:
  // The layer's place, that of older files, and, for short, right under the node.
  std::vector<std::string> in(const std::string & layer, const std::string & name) const
  {
    return {costmap_ + "/" + layer + "/" + name, costmap_ + "/" + name, name};
  }

  std::string costmap_;
  std::string static_{"static_layer"};
  std::string obstacle_{"obstacle_layer"};
  std::string inflation_{"inflation_layer"};
};

void readFrames(ParameterReader & reader, MoveBaseParameters & parameters)
{
  reader.read("global_costmap/global_frame", parameters.global_frame);
  reader.read("local_costmap/global_frame", parameters.local_frame);
  reader.read(ofCostmap("global_costmap", "robot_base_frame"), parameters.base_frame);
  reader.read(ofCostmap("global_costmap", "transform_tolerance"), parameters.transform_tolerance, atLeast(0.0));
}

// The first lidar among the observation sources of the original's obstacle layer.
void readScanTopic(ParameterReader & reader, const Layers & layers, MoveBaseParameters & parameters)
{
  std::string sources;
  reader.read(layers.ofObstacle("observation_sources"), sources);
  std::istringstream names(sources);
  for (std::string source; names >> source;) {
    std::string type;
    std::string topic = source;
    reader.read(layers.ofObstacle(source + "/data_type"), type);
    reader.read(layers.ofObstacle(source + "/topic"), topic);
    if (type == "LaserScan") {
      parameters.scan_topic = topic;
      return;
    }
  }
}

void readShown(ParameterReader & reader, MoveBaseParameters & parameters)
{
  reader.read("global_costmap/publish_frequency", parameters.global_publish_frequency);
  reader.read("local_costmap/publish_frequency", parameters.local_publish_frequency);
  reader.read("global_costmap/always_send_full_costmap", parameters.global_always_whole);
  reader.read("local_costmap/always_send_full_costmap", parameters.local_always_whole);
  reader.read("local_costmap/width", parameters.local_width, positive());
  reader.read("local_costmap/height", parameters.local_height, positive());
  reader.read("local_costmap/resolution", parameters.local_resolution, positive());
}
}  // namespace

void readCostmaps(ParameterReader & reader, MoveBaseParameters & parameters)
{
  readFrames(reader, parameters);
  const Layers global(reader, "global_costmap");
  const Layers local(reader, "local_costmap");
  reader.read(global.ofStatic("map_topic"), parameters.map_topic);
  readScanTopic(reader, global, parameters);
  readScanTopic(reader, local, parameters);
  readShown(reader, parameters);

  parameters.footprint = defaultFootprint();
  reader.read(ofCostmap("global_costmap", "footprint"), parameters.footprint);
  reader.read(ofCostmap("global_costmap", "footprint_padding"), parameters.footprint_padding);

  CostmapOptions & costmap = parameters.costmap;
  reader.read(global.ofStatic("lethal_cost_threshold"), costmap.lethal_cost_threshold);
  reader.read(global.ofInflation("inflation_radius"), costmap.inflation_radius);
  reader.read(global.ofInflation("cost_scaling_factor"), costmap.cost_scaling_factor);
  reader.read(local.ofObstacle("obstacle_range"), costmap.live.obstacle_range);
  reader.read(local.ofObstacle("raytrace_range"), costmap.live.raytrace_range);
}
}  // namespace move_base
