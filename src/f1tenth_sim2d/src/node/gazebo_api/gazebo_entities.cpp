#include "node/gazebo_api/gazebo_entities.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/errors.h"
#include "node/messages/conversions.h"

namespace f1tenth_sim2d
{
namespace
{
/// Something that is fixed to a car, at a pose in the car's frame.
Entity onCar(const Simulation & simulation, CarId car, Entity::Kind kind, const std::string & name, const Pose3 & mount)
{
  const CarState & state = simulation.state(car);
  const Pose3 pose = onGround(state.pose) * mount;
  const Vec2 velocity = rotated(state.velocity, state.pose.yaw);
  const Vec2 arm{pose.position.x() - state.pose.x, pose.position.y() - state.pose.y};
  return {kind, 0, car, name, pose, velocityAt(velocity, state.yaw_rate, arm), state.yaw_rate};
}

std::vector<Entity> models(const Simulation & simulation)
{
  std::vector<Entity> result;
  for (std::size_t i = 0; i < simulation.models().size(); ++i) {
    const ModelDescription & model = simulation.models()[i];
    const ModelState state = simulation.modelState(i);
    result.push_back(
      {Entity::Kind::kModel,
       i,
       {},
       model.name,
       onGround(state.pose) * withoutPlanar(model.pose),
       state.velocity,
       state.yaw_rate});
  }
  return result;
}
}  // namespace

std::vector<Entity> entities(const Simulation & simulation)
{
  std::vector<Entity> result = models(simulation);
  for (const CarId car : simulation.cars()) {
    const CarDescription & description = simulation.car(car);
    result.push_back(onCar(simulation, car, Entity::Kind::kCar, description.name, description.model_pose));
  }
  return result;
}

std::vector<Entity> links(const Simulation & simulation)
{
  std::vector<Entity> result;
  for (const CarId car : simulation.cars()) {
    const CarDescription & description = simulation.car(car);
    for (const auto & [link, pose] : description.link_poses) {
      result.push_back(onCar(simulation, car, Entity::Kind::kLink, description.name + "::" + link, pose));
    }
  }
  return result;
}

std::optional<Entity> find(const Simulation & simulation, const std::string & name)
{
  std::vector<Entity> all = entities(simulation);
  const std::vector<Entity> more = links(simulation);
  all.insert(all.end(), more.begin(), more.end());
  const auto isCalled = [&name](const Entity & entity) { return entity.name == name; };
  const auto endsWith = [ending = "::" + name](const Entity & entity) {
    return boost::algorithm::ends_with(entity.name, ending);
  };
  auto found = std::find_if(all.begin(), all.end(), isCalled);
  if (found == all.end() && !name.empty()) {
    found = std::find_if(all.begin(), all.end(), endsWith);
  }
  return found == all.end() ? std::nullopt : std::make_optional(*found);
}

bool isWorld(const std::string & name)
{
  return name.empty() || name == "world" || name == "map" || name == "/map";
}

Pose3 fromPose(const geometry_msgs::Pose & pose)
{
  const Pose3::Rotation given(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  if (!std::isfinite(given.norm())) {
    throw Error(
      "the orientation (x y z w) is " + toText(given.x()) + " " + toText(given.y()) + " " + toText(given.z()) + " " +
      toText(given.w()) + ", allowed are finite numbers");
  }
  // As in gazebo_ros: a quaternion that was not set means no rotation.
  const Pose3::Rotation rotation = given.norm() > 0.0 ? given.normalized() : Pose3::Rotation::Identity();
  return {{pose.position.x, pose.position.y, pose.position.z}, rotation};
}

geometry_msgs::Twist twistOf(const Entity & entity)
{
  return toTwist(entity.velocity, entity.yaw_rate);
}

Pose2 carPose(const CarDescription & car, const Pose3 & model_pose)
{
  return planar(model_pose * car.model_pose.inverse());
}
}  // namespace f1tenth_sim2d
