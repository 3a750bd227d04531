#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace f1tenth_scenarios
{
/// Names of nodes by topic, as the ROS master has them.
using NodesByTopic = std::map<std::string, std::set<std::string>>;

/// Whether any of the nodes is in the namespace of one of the cars.
inline bool isOfCar(const std::set<std::string> & nodes, const std::vector<std::string> & cars)
{
  return std::any_of(nodes.begin(), nodes.end(), [&cars](const std::string & node) {
    return std::any_of(
      cars.begin(), cars.end(), [&node](const std::string & car) { return node.rfind("/" + car + "/", 0) == 0; });
  });
}

/// What the nodes in the namespaces of some cars publish and hear, wherever the topics are.
///
/// Costmaps are left out: they would be most of a bag. So are the copies that the proxy driver passes on, and what the
/// simulator would only publish for the bag, as pictures of a camera that no planner looks at.
inline std::set<std::string> topicsOfCars(
  const NodesByTopic & publishers, const NodesByTopic & subscribers, const std::vector<std::string> & cars)
{
  std::set<std::string> found;
  for (const NodesByTopic * ends : {&publishers, &subscribers}) {
    for (const auto & [topic, nodes] : *ends) {
      const bool is_copy = topic.find("/proxy_driver/") != std::string::npos;
      if (!is_copy && topic.find("costmap") == std::string::npos && isOfCar(nodes, cars)) {
        found.insert(topic);
      }
    }
  }
  return found;
}
}  // namespace f1tenth_scenarios
