#include "node/app/spawner.h"

#include <malloc.h>
#include <ros/param.h>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "node/app/scene.h"
#include "node/gazebo_api/gazebo_entities.h"

namespace f1tenth_sim2d
{
namespace
{
std::string trimmedOfSlashes(const std::string & name)
{
  const auto begin = name.find_first_not_of('/');
  return begin == std::string::npos ? "" : name.substr(begin, name.find_last_not_of('/') - begin + 1);
}

// As the plugins of gazebo_ros do: a tf_prefix in the car's namespace, or above it, stands before its frames.
std::string framePrefix(const std::string & ros_namespace)
{
  std::string key;
  std::string prefix;
  if (ros::param::search(ros_namespace, "tf_prefix", key)) {
    ros::param::get(key, prefix);
  }
  prefix = trimmedOfSlashes(prefix);
  return prefix.empty() ? "" : prefix + "/";
}
}  // namespace

void Spawner::spawn(const Request & request)
{
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
  parameters.ros_namespace = "/" + trimmedOfSlashes(request.ros_namespace);
  const CarDescription description =
    loadCar(request.xml, request.name, source, searchPathFromEnvironment(), parameters.ros_namespace.substr(1));
  warnOnce(description.source, description.warnings);
  parameters.frame_prefix = framePrefix(parameters.ros_namespace);
  fleet_.add(parameters, description, description.parameters, carPose(description, request.pose));
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
