#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Twist.h>

#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// A model of the world, a car, or a link of a car ("robot1::chassis"), as gazebo_ros sees it: in the world's frame.
struct Entity
{
  enum class Kind
  {
    kModel,
    kCar,
    kLink
  } kind;
  std::size_t model;  ///< index of a model
  CarId car;          ///< of a car or link
  std::string name;
  Pose3 pose;            ///< of its own frame
  Vec2 velocity;         ///< m/s, of the origin of its frame
  double yaw_rate{0.0};  ///< rad/s
};

/// Models in the order in which they came, then cars.
std::vector<Entity> entities(const Simulation & simulation);
/// Links of all cars, joints at zero. Links of models are no longer known.
std::vector<Entity> links(const Simulation & simulation);
/// A model, car or link: by its name, or, as in Gazebo, the first one that has it behind the names of what is around it.
std::optional<Entity> find(const Simulation & simulation, const std::string & name);
/// Whether a name stands for the world's frame: "", "world", "map" and the like.
bool isWorld(const std::string & name);

/// @throws Error for an orientation that is not finite
Pose3 fromPose(const geometry_msgs::Pose & pose);
geometry_msgs::Twist twistOf(const Entity & entity);
/// Where the car's own frame is when the frame of its model is at a pose.
Pose2 carPose(const CarDescription & car, const Pose3 & model_pose);
}  // namespace f1tenth_sim2d
