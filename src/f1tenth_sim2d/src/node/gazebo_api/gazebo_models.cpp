#include "node/gazebo_api/gazebo_models.h"

#include <ros/console.h>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/errors.h"
#include "node/gazebo_api/heights.h"
#include "node/gazebo_api/spawner.h"
#include "node/messages/conversions.h"

namespace f1tenth_sim2d
{
namespace
{
/// A service that answers `done` if it worked, else the text of the exception.
/// @param worked  told of every request that did
template <class Request, class Response, class Worked>
boost::function<bool(ros::ServiceEvent<Request, Response> &)> answering(
  GazeboModels & models, void (GazeboModels::*answer)(const Request &, Response &), const std::string & title,
  const std::string & done, const Worked & worked)
{
  return [=, &models](ros::ServiceEvent<Request, Response> & event) {
    Response & response = event.getResponse();
    try {
      (models.*answer)(event.getRequest(), response);
      worked(event.getRequest(), event.getCallerName());
      response.success = true;
      response.status_message = title + done;
    } catch (const std::exception & error) {  // ROS has exceptions of its own, for names that it does not accept
      response.success = false;
      response.status_message = title + error.what();
    }
    return true;
  };
}

const std::string & modelOf(const gazebo_msgs::SetModelState::Request & request)
{
  return request.model_state.model_name;
}

template <class Request>
const std::string & modelOf(const Request & request)
{
  return request.model_name;
}

/// What a name stands for, the world itself too.
/// @throws Error with `missing` for an unknown name
Entity reference(const Simulation & simulation, const std::string & name, const char * missing)
{
  if (isWorld(name)) {
    return Entity{Entity::Kind::kModel, 0, {}, name, {}, {}, 0.0};
  }
  if (const auto entity = find(simulation, name)) {
    return *entity;
  }
  throw Error(missing);
}

/// As in Gazebo, the velocity of the reference's origin is subtracted, not that of its frame where the other is.
Entity seenFrom(const Entity & reference, Entity entity)
{
  entity.pose = reference.pose.inverse() * entity.pose;
  entity.velocity = rotated(entity.velocity - reference.velocity, -reference.pose.yaw());
  entity.yaw_rate -= reference.yaw_rate;
  return entity;
}

/// Whether a model is a body of its own that is nested in the one of this name.
bool isNestedIn(const std::string & name, const ModelDescription & model)
{
  return model.name.rfind(name + "::", 0) == 0;
}

void removeWithNested(Simulation & simulation, const std::string & name)
{
  for (std::size_t i = simulation.models().size(); i-- > 0;) {
    const ModelDescription & model = simulation.models()[i];
    if (model.name == name || isNestedIn(name, model)) {
      simulation.removeModel(i);
    }
  }
}

/// As in Gazebo, what is nested in the model goes along, but keeps its velocity.
void placeWithNested(Simulation & simulation, const Entity & entity, const ModelState & state, double lift)
{
  const Pose2 before = simulation.modelState(entity.model).pose;
  simulation.placeModel(entity.model, state, lift);
  for (std::size_t i = 0; i < simulation.models().size(); ++i) {
    if (isNestedIn(entity.name, simulation.models()[i])) {
      ModelState nested = simulation.modelState(i);
      nested.pose = chain(state.pose, workspace_support::compose(workspace_support::inverse(before), nested.pose));
      simulation.placeModel(i, nested, lift);
    }
  }
}
}  // namespace

GazeboModels::GazeboModels(
  ros::NodeHandle & node, Simulation & simulation, Fleet & fleet, InterventionLog & interventions)
: simulation_(simulation), fleet_(fleet), interventions_(interventions)
{
  const auto serve = [&](const std::string & name, const std::string & title, const std::string & done, auto answer) {
    const auto ignore = [](const auto & /*request*/, const std::string & /*caller*/) {};
    servers_.push_back(node.advertiseService("/gazebo/" + name, answering(*this, answer, title + ": ", done, ignore)));
  };
  const auto change = [&](const std::string & name, const std::string & title, const std::string & done, auto answer) {
    const auto note = [this, name](const auto & request, const std::string & caller) {
      interventions_.add(simulation_.time(), {name, caller, modelOf(request)});
    };
    servers_.push_back(node.advertiseService("/gazebo/" + name, answering(*this, answer, title + ": ", done, note)));
  };
  change("spawn_urdf_model", "SpawnModel", "Successfully spawned entity", &GazeboModels::spawn);
  change("spawn_sdf_model", "SpawnModel", "Successfully spawned entity", &GazeboModels::spawn);
  change("delete_model", "DeleteModel", "successfully deleted model", &GazeboModels::remove);
  serve("get_model_state", "GetModelState", "got properties", &GazeboModels::getState);
  change("set_model_state", "SetModelState", "set model state done", &GazeboModels::setState);
  serve("get_link_state", "GetLinkState", "got state", &GazeboModels::getLinkState);
  serve("get_model_properties", "GetModelProperties", "got properties", &GazeboModels::getProperties);
  using StateEvent = ros::MessageEvent<const gazebo_msgs::ModelState>;
  const boost::function<void(const StateEvent &)> take = [this](const StateEvent & event) {
    const gazebo_msgs::ModelState & wanted = *event.getConstMessage();
    try {
      put(wanted);
      interventions_.add(simulation_.time(), {"set_model_state", event.getPublisherName(), wanted.model_name});
    } catch (const Error & error) {
      ROS_WARN("SetModelState: %s", error.what());
    }
  };
  state_subscriber_ = node.subscribe<const StateEvent &>("/gazebo/set_model_state", 10, take);
}

/// A model or a car.
Entity GazeboModels::model(const std::string & name) const
{
  const auto entity = find(simulation_, name);
  if (!entity || entity->kind == Entity::Kind::kLink) {
    throw Error("model does not exist");
  }
  return *entity;
}

void GazeboModels::spawn(const gazebo_msgs::SpawnModel::Request & request, gazebo_msgs::SpawnModel::Response &)
{
  if (request.model_name.empty()) {
    throw Error("Failure - model_name is empty, allowed is a name that no model has");
  }
  if (find(simulation_, request.model_name)) {
    throw Error("Failure - model name " + request.model_name + " already exist.");
  }
  const Entity from = reference(
    simulation_, request.reference_frame,
    "reference reference_frame not found, did you forget to scope the link by model name?");
  try {
    spawnEntity(
      {request.model_name, request.model_xml, request.robot_namespace, from.pose * fromPose(request.initial_pose)},
      simulation_, fleet_);
  } catch (const std::exception & error) {
    throw Error(std::string("Failure - ") + error.what());
  }
}

void GazeboModels::remove(const gazebo_msgs::DeleteModel::Request & request, gazebo_msgs::DeleteModel::Response &)
{
  const Entity entity = model(request.model_name);
  if (entity.kind == Entity::Kind::kCar) {
    fleet_.remove(entity.car);
  } else {
    removeWithNested(simulation_, request.model_name);
  }
}

void GazeboModels::getState(
  const gazebo_msgs::GetModelState::Request & request, gazebo_msgs::GetModelState::Response & response)
{
  const Entity entity = model(request.model_name);
  response.header.seq = ++state_requests_[request.model_name];
  response.header.stamp = toRosTime(simulation_.time());
  response.header.frame_id = request.relative_entity_name;
  const Entity from = reference(
    simulation_, request.relative_entity_name,
    "reference relative_entity_name not found, did you forget to scope the body by model name?");
  const Entity seen = seenFrom(from, entity);
  response.pose = toPose(seen.pose);
  response.twist = twistOf(seen);
}

void GazeboModels::setState(const gazebo_msgs::SetModelState::Request & request, gazebo_msgs::SetModelState::Response &)
{
  put(request.model_state);
}

void GazeboModels::put(const gazebo_msgs::ModelState & wanted)
{
  const Entity entity = model(wanted.model_name);
  const Entity from = reference(simulation_, wanted.reference_frame, "specified reference frame entity does not exist");
  const auto pose = from.pose * fromPose(wanted.pose);
  const Vec2 velocity = rotated({wanted.twist.linear.x, wanted.twist.linear.y}, from.pose.yaw());
  const double yaw_rate = wanted.twist.angular.z;
  if (entity.kind == Entity::Kind::kModel) {
    warnOfTilt(entity, pose);
    const double lift = liftOf(simulation_.models()[entity.model], pose.position.z());
    placeWithNested(simulation_, entity, {planar(pose), velocity, yaw_rate}, lift);
    return;
  }
  requireAboveGround(entity, pose);
  const Pose2 place = carPose(simulation_.car(entity.car), pose);
  const Vec2 arm{place.x - pose.position.x(), place.y - pose.position.y()};
  const Vec2 own = velocityAt(velocity, yaw_rate, arm);
  simulation_.placeCar(entity.car, place, rotated(own, -place.yaw), yaw_rate);
}

void GazeboModels::getLinkState(
  const gazebo_msgs::GetLinkState::Request & request, gazebo_msgs::GetLinkState::Response & response)
{
  const auto link = find(simulation_, request.link_name);
  if (!link || link->kind != Entity::Kind::kLink) {
    throw Error("link not found, did you forget to scope the link by model name?");
  }
  const Entity from = reference(
    simulation_, request.reference_frame, "reference link not found, did you forget to scope the link by model name?");
  const Entity seen = seenFrom(from, *link);
  response.link_state.link_name = request.link_name;
  response.link_state.pose = toPose(seen.pose);
  response.link_state.twist = twistOf(seen);
  response.link_state.reference_frame = request.reference_frame;
}

void GazeboModels::getProperties(
  const gazebo_msgs::GetModelProperties::Request & request, gazebo_msgs::GetModelProperties::Response & response)
{
  const Entity entity = model(request.model_name);
  const bool is_car = entity.kind == Entity::Kind::kCar;
  response.is_static = !is_car && simulation_.models()[entity.model].is_static;
  const auto & solids = is_car ? simulation_.car(entity.car).solids : simulation_.models()[entity.model].solids;
  for (const Solid & solid : solids) {
    response.geom_names.push_back(solid.name.substr(solid.name.rfind(':') + 1));
  }
  if (is_car) {
    const CarDescription & car = simulation_.car(entity.car);
    response.body_names = car.links;
    response.canonical_body_name = car.base_frame;
    for (const JointDescription & joint : car.mechanism) {
      response.joint_names.push_back(joint.name);
    }
  }
}
}  // namespace f1tenth_sim2d
