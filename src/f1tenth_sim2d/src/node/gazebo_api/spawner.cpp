#include "node/gazebo_api/spawner.h"

#include <malloc.h>
#include <ros/console.h>
#include <ros/param.h>
#include <workspace_support/maths/trigonometry.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
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
      places.push_back({pose.x + radius * maths::cos(angle), pose.y + radius * maths::sin(angle), pose.yaw});
    }
  }
  return places;
}

// As in the plugins of gazebo_ros: a tf_prefix in the car's namespace, or above it, is put before its frames.
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

// As in Gazebo, a car that would stand in something is pushed out of it.
void addNear(const CarParameters & parameters, const CarDescription & car, const Pose2 & pose, Fleet & fleet)
{
  std::string complaint;
  for (const Pose2 & place : placesAround(pose, kLengthPerWheelbase * car.parameters.wheelbase())) {
    try {
      fleet.add(parameters, car, car.parameters, place);
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

void spawnCar(const SpawnRequest & request, const std::string & source, Fleet & fleet)
{
  CarParameters parameters;
  parameters.name = request.name;
  parameters.ros_namespace = "/" + boost::algorithm::trim_copy_if(request.ros_namespace, is_any_of("/"));
  const CarDescription description =
    loadCar(request.xml, request.name, source, searchPathFromEnvironment(), parameters.ros_namespace.substr(1));
  warnOnce(description.source, description.warnings);
  parameters.frame_prefix = framePrefix(parameters.ros_namespace);
  addNear(parameters, description, carPose(description, request.pose * description.own_pose), fleet);
}

/// All or nothing: a model and those nested in it that are bodies of their own.
void addModels(const std::vector<ModelDescription> & models, Simulation & simulation)
{
  const std::size_t before = simulation.models().size();
  try {
    for (const auto & model : models) {
      simulation.addModel(model);
    }
  } catch (...) {
    while (simulation.models().size() > before) {
      simulation.removeModel(simulation.models().size() - 1);
    }
    throw;
  }
}

void spawnModel(const SpawnRequest & request, const std::string & source, Simulation & simulation)
{
  const LoadedModel loaded = loadModel(request.xml, request.name, request.pose, source, searchPathFromEnvironment());
  if (loaded.models.empty() || loaded.models.front().name != request.name) {
    throw Error(
      source +
      ": model has no <link> of its own, and its nested models move apart; allowed are models with a <link>, or whose "
      "nested ones are joined by a <joint>, are static or only one");
  }
  warnOnce(source, loaded.warnings);
  addModels(loaded.models, simulation);
}
}  // namespace

void spawnEntity(const SpawnRequest & request, Simulation & simulation, Fleet & fleet)
{
  const std::string source = "description of " + request.name;
  if (describesCar(request.xml, source)) {
    spawnCar(request, source, fleet);
  } else {
    spawnModel(request, source, simulation);
  }
  malloc_trim(0);
}
}  // namespace f1tenth_sim2d
