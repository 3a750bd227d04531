#include "node/gazebo_api/gazebo_models.h"

#include <ros/console.h>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/errors.h"
#include "node/gazebo_api/spawner.h"
#include "node/messages/conversions.h"

namespace f1tenth_sim2d
{
namespace
{
template <class Response>
bool answer(Response & response, bool success, const std::string & message)
{
  response.success = success;
  response.status_message = message;
  return true;
}

/// The world itself for the names that mean it; nothing for an unknown name.
std::optional<Entity> findReference(const Simulation & simulation, const std::string & name)
{
  if (isWorld(name)) {
    return Entity{Entity::Kind::kModel, 0, {}, name, {}, {}, 0.0};
  }
  return find(simulation, name);
}

/// As in Gazebo, the twist is turned into the reference frame, not made relative to its motion.
Entity seenFrom(const Entity & reference, Entity entity)
{
  entity.pose = reference.pose.inverse() * entity.pose;
  entity.velocity = rotated(entity.velocity, -reference.pose.yaw());
  return entity;
}

/// A model and those nested in it that are bodies of their own.
void removeWithNested(Simulation & simulation, const std::string & name)
{
  for (std::size_t i = simulation.models().size(); i-- > 0;) {
    const std::string & each = simulation.models()[i].name;
    if (each == name || each.rfind(name + "::", 0) == 0) {
      simulation.removeModel(i);
    }
  }
}

bool isModel(const std::optional<Entity> & entity)
{
  return entity && entity->kind != Entity::Kind::kLink;
}
}  // namespace

GazeboModels::GazeboModels(ros::NodeHandle & node, Simulation & simulation, Fleet & fleet)
: simulation_(simulation), fleet_(fleet)
{
  const auto serve = [&](const std::string & name, auto method) {
    servers_.push_back(node.advertiseService("/gazebo/" + name, method, this));
  };
  serve("spawn_urdf_model", &GazeboModels::spawn);
  serve("spawn_sdf_model", &GazeboModels::spawn);
  serve("delete_model", &GazeboModels::remove);
  serve("get_model_state", &GazeboModels::getState);
  serve("set_model_state", &GazeboModels::setState);
  serve("get_link_state", &GazeboModels::getLinkState);
  serve("get_model_properties", &GazeboModels::getProperties);
  state_subscriber_ = node.subscribe<gazebo_msgs::ModelState>(
    "/gazebo/set_model_state", 10, [this](const gazebo_msgs::ModelState::ConstPtr & message) {
      gazebo_msgs::SetModelState set;
      set.request.model_state = *message;
      setState(set.request, set.response);
      if (!set.response.success) {
        ROS_WARN("%s", set.response.status_message.c_str());
      }
    });
}

bool GazeboModels::spawn(gazebo_msgs::SpawnModel::Request & request, gazebo_msgs::SpawnModel::Response & response)
{
  if (find(simulation_, request.model_name)) {
    return answer(response, false, "SpawnModel: Failure - model name " + request.model_name + " already exist.");
  }
  const auto reference = findReference(simulation_, request.reference_frame);
  if (!reference) {
    return answer(
      response, false,
      "SpawnModel: reference reference_frame not found, did you forget to scope the link by model name?");
  }
  try {
    spawnEntity(
      {request.model_name, request.model_xml, request.robot_namespace,
       reference->pose * fromPose(request.initial_pose)},
      simulation_, fleet_);
  } catch (const std::exception & error) {  // ROS has exceptions of its own, for names that it does not take
    return answer(response, false, std::string("SpawnModel: Failure - ") + error.what());
  }
  return answer(response, true, "SpawnModel: Successfully spawned entity");
}

bool GazeboModels::remove(gazebo_msgs::DeleteModel::Request & request, gazebo_msgs::DeleteModel::Response & response)
{
  const auto entity = find(simulation_, request.model_name);
  if (!isModel(entity)) {
    return answer(response, false, "DeleteModel: model does not exist");
  }
  if (entity->kind == Entity::Kind::kCar) {
    fleet_.remove(entity->car);
  } else {
    removeWithNested(simulation_, request.model_name);
  }
  return answer(response, true, "DeleteModel: successfully deleted model");
}

bool GazeboModels::getState(
  gazebo_msgs::GetModelState::Request & request, gazebo_msgs::GetModelState::Response & response)
{
  const auto entity = find(simulation_, request.model_name);
  if (!isModel(entity)) {
    return answer(response, false, "GetModelState: model does not exist");
  }
  const auto reference = findReference(simulation_, request.relative_entity_name);
  if (!reference) {
    return answer(
      response, false,
      "GetModelState: reference relative_entity_name not found, did you forget to scope the body by model name?");
  }
  const Entity seen = seenFrom(*reference, *entity);
  response.header.stamp = toRosTime(simulation_.time());
  response.header.frame_id = request.relative_entity_name.empty() ? "world" : request.relative_entity_name;
  response.pose = toPose(seen.pose);
  response.twist = twistOf(seen);
  return answer(response, true, "GetModelState: got properties");
}

bool GazeboModels::setState(
  gazebo_msgs::SetModelState::Request & request, gazebo_msgs::SetModelState::Response & response)
{
  const auto entity = find(simulation_, request.model_state.model_name);
  if (!isModel(entity)) {
    return answer(response, false, "SetModelState: model does not exist");
  }
  const auto reference = findReference(simulation_, request.model_state.reference_frame);
  if (!reference) {
    return answer(response, false, "SetModelState: specified reference frame entity does not exist");
  }
  try {
    put(request.model_state, *entity, *reference);
  } catch (const Error & error) {
    return answer(response, false, std::string("SetModelState: ") + error.what());
  }
  return answer(response, true, "SetModelState: set model state done");
}

void GazeboModels::put(const gazebo_msgs::ModelState & wanted, const Entity & entity, const Entity & reference)
{
  const auto pose = reference.pose * fromPose(wanted.pose);
  const Vec2 velocity = rotated({wanted.twist.linear.x, wanted.twist.linear.y}, reference.pose.yaw());
  const double yaw_rate = wanted.twist.angular.z;
  if (entity.kind == Entity::Kind::kModel) {
    simulation_.placeModel(entity.model, {planar(pose), velocity, yaw_rate});
    return;
  }
  const Pose2 place = carPose(simulation_.car(entity.car), pose);
  const Vec2 arm{place.x - pose.position.x(), place.y - pose.position.y()};
  const Vec2 own{velocity.x - yaw_rate * arm.y, velocity.y + yaw_rate * arm.x};
  simulation_.placeCar(entity.car, place, rotated(own, -place.yaw), yaw_rate);
}

bool GazeboModels::getLinkState(
  gazebo_msgs::GetLinkState::Request & request, gazebo_msgs::GetLinkState::Response & response)
{
  const auto link = find(simulation_, request.link_name);
  if (!link || link->kind != Entity::Kind::kLink) {
    return answer(response, false, "GetLinkState: link not found, did you forget to scope the link by model name?");
  }
  const auto reference = findReference(simulation_, request.reference_frame);
  if (!reference) {
    return answer(
      response, false, "GetLinkState: reference link not found, did you forget to scope the link by model name?");
  }
  const Entity seen = seenFrom(*reference, *link);
  response.link_state.link_name = request.link_name;
  response.link_state.pose = toPose(seen.pose);
  response.link_state.twist = twistOf(seen);
  response.link_state.reference_frame = request.reference_frame;
  return answer(response, true, "GetLinkState: got state");
}

bool GazeboModels::getProperties(
  gazebo_msgs::GetModelProperties::Request & request, gazebo_msgs::GetModelProperties::Response & response)
{
  const auto entity = find(simulation_, request.model_name);
  if (!isModel(entity)) {
    return answer(response, false, "GetModelProperties: model does not exist");
  }
  const bool is_car = entity->kind == Entity::Kind::kCar;
  response.is_static = !is_car && simulation_.models()[entity->model].is_static;
  const auto & solids = is_car ? simulation_.car(entity->car).solids : simulation_.models()[entity->model].solids;
  for (const Solid & solid : solids) {
    response.geom_names.push_back(solid.name.substr(solid.name.rfind(':') + 1));
  }
  if (is_car) {
    const CarDescription & car = simulation_.car(entity->car);
    response.body_names = car.links;
    response.canonical_body_name = car.base_frame;
    for (const JointDescription & joint : car.mechanism) {
      response.joint_names.push_back(joint.name);
    }
  }
  return answer(response, true, "GetModelProperties: got properties");
}
}  // namespace f1tenth_sim2d
