#include "node/gazebo_api/spawner.h"

#include <malloc.h>
#include <ros/console.h>
#include <ros/param.h>
#include <tinyxml2.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/occupied_place.h"
#include "node/gazebo_api/gazebo_entities.h"
#include "node/world/warnings.h"

namespace f1tenth_sim2d
{
namespace
{
using boost::algorithm::is_any_of;

constexpr double kLengthPerWheelbase = 1.6;
constexpr double kStep = 0.05;  // m, between places that are tried
constexpr int kDirections = 16;

/// A place, then those around it up to a distance, the nearest first.
std::vector<Pose2> placesAround(const Pose2 & pose, double limit)
{
  std::vector<Pose2> places{pose};
  for (double radius = kStep; radius <= limit; radius += kStep) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = pose.yaw + 2.0 * M_PI * i / kDirections;
      places.push_back({pose.x + radius * std::cos(angle), pose.y + radius * std::sin(angle), pose.yaw});
    }
  }
  return places;
}

// As gazebo_ros does: a description may leave its name to whoever spawns it.
std::string withName(const std::string & xml, const std::string & name)
{
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.c_str(), xml.size()) != tinyxml2::XML_SUCCESS) {
    return xml;
  }
  tinyxml2::XMLElement * const root = document.RootElement();
  tinyxml2::XMLElement * const model = root->FirstChildElement("model");
  tinyxml2::XMLElement * const named = model != nullptr ? model : root;
  const char * const own = named->Attribute("name");
  if (own == nullptr || *own != '\0') {
    return xml;
  }
  named->SetAttribute("name", name.c_str());
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

// As the plugins of gazebo_ros do: a tf_prefix in the car's namespace, or above it, stands before its frames.
std::string framePrefix(const std::string & ros_namespace)
{
  std::string key;
  std::string prefix;
  if (ros::param::search(ros_namespace, "tf_prefix", key)) {
    ros::param::get(key, prefix);
  }
  boost::algorithm::trim_if(prefix, is_any_of("/"));
  return prefix.empty() ? "" : prefix + "/";
}
}  // namespace

void Spawner::spawn(const Request & asked)
{
  Request request = asked;
  request.xml = withName(asked.xml, asked.name);
  const std::string source = "description of " + request.name;
  if (describesCar(request.xml, source)) {
    spawnCar(request, source);
  } else {
    spawnModel(request, source);
  }
  malloc_trim(0);
}

void Spawner::spawnCar(const Request & request, const std::string & source)
{
  CarParameters parameters;
  parameters.name = request.name;
  parameters.ros_namespace = "/" + boost::algorithm::trim_copy_if(request.ros_namespace, is_any_of("/"));
  const CarDescription description =
    loadCar(request.xml, request.name, source, searchPathFromEnvironment(), parameters.ros_namespace.substr(1));
  warnOnce(description.source, description.warnings);
  parameters.frame_prefix = framePrefix(parameters.ros_namespace);
  addNear(parameters, description, carPose(description, request.pose));
}

// As in Gazebo, a car that would stand in something is pushed out of it.
void Spawner::addNear(const CarParameters & parameters, const CarDescription & car, const Pose2 & pose)
{
  std::string complaint;
  for (const Pose2 & place : placesAround(pose, kLengthPerWheelbase * car.parameters.wheelbase())) {
    try {
      fleet_.add(parameters, car, car.parameters, place);
    } catch (const OccupiedPlace & error) {
      complaint = complaint.empty() ? error.what() : complaint;
      continue;
    }
    if (!complaint.empty()) {
      ROS_WARN(
        "%s; it stands %.2f m beside it, at (%.2f, %.2f)", complaint.c_str(), distance(place, pose), place.x, place.y);
    }
    return;
  }
  throw OccupiedPlace(complaint + ", and no place within a car's length is free");
}

void Spawner::spawnModel(const Request & request, const std::string & source)
{
  const LoadedModel loaded = loadModel(request.xml, request.name, request.pose, source, searchPathFromEnvironment());
  warnOnce(source, loaded.warnings);
  for (const auto & model : loaded.models) {
    simulation_.addModel(model);
  }
}
}  // namespace f1tenth_sim2d
