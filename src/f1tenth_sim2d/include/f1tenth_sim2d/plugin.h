#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>

#include <string>

#include "f1tenth_sim2d/publishing.h"
#include "f1tenth_sim2d/simulation.h"

/// Public header for simulator plugins: shared libraries that the node loads for a car's <plugin filename="lib….so">.
namespace f1tenth_sim2d
{
/// What a plugin may use. Everything outlives the plugin.
struct CarPluginContext
{
  const Simulation & simulation;
  CarId car;             ///< valid as long as the plugin lives
  ros::NodeHandle node;  ///< in the car's namespace
  Advertiser & advertiser;
  TransformSender & transforms;
  std::string frame_prefix;      ///< put before every frame id, "robot1/" or ""
  bool owns_odometry_transform;  ///< whether perfect odometry publishes odom -> base_footprint
};

/// Base class of car plugins: components of their car, whose hooks are called if acts() says so. Register with CLASS_LOADER_REGISTER_CLASS(MyPlugin, f1tenth_sim2d::CarPlugin).
class CarPlugin : public Component
{
public:
  /// Called once, before the first step.
  /// @throws Error for a wrong parameter, naming element.place, the tag, what was found and what is allowed
  virtual void load(const PluginElement & element, const CarPluginContext & context) = 0;

  /// Rate at which update() is to be called, to publish, Hz of simulated time; 0: after every physics step.
  virtual double updateRate() const = 0;

  /// Called at each multiple of 1 / updateRate() of simulated time, after the physics step that ends there.
  virtual void update(const ros::Time & stamp) = 0;
};
}  // namespace f1tenth_sim2d
