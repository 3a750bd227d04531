#include "gazebo_api.h"

#include <algorithm>

#include "conversions.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kModelStatesRate = 50.0;  // Hz

bool isWorld(const std::string & name)
{
  return name.empty() || name == "world" || name == "map";
}

std::optional<Entity> find(const Simulation & simulation, const std::string & name)
{
  const auto all = entities(simulation);
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entity & entity) { return entity.name == name; });
  return found == all.end() ? std::nullopt : std::make_optional(*found);
}
}  // namespace

std::vector<Entity> entities(const Simulation & simulation)
{
  std::vector<Entity> result;
  for (const auto & name : simulation.modelNames()) {
    result.push_back({name, simulation.modelPose(name), {}, 0.0});
  }
  for (CarIndex car = 0; car < simulation.carCount(); ++car) {
    const CarState & state = simulation.state(car);
    result.push_back({simulation.car(car).name, state.pose, rotated(state.velocity, state.pose.yaw), state.yaw_rate});
  }
  return result;
}

ModelStatesOutput::ModelStatesOutput(
  Advertiser & advertiser, const ros::NodeHandle & node, const Simulation & simulation)
: MessageOutput(advertiser.advertise<gazebo_msgs::ModelStates>(node, "/gazebo/model_states"), kModelStatesRate),
  simulation_(simulation)
{
}

void ModelStatesOutput::fill(gazebo_msgs::ModelStates & message, SimTime /*now*/)
{
  message.name.clear();
  message.pose.clear();
  message.twist.clear();
  for (const auto & entity : entities(simulation_)) {
    message.name.push_back(entity.name);
    message.pose.push_back(toPose(entity.pose));
    message.twist.push_back(toTwist(entity.velocity, entity.yaw_rate));
  }
}

GazeboServices::GazeboServices(
  ros::NodeHandle & node, const Simulation & simulation, TimeControl & control, std::function<void()> restart)
: simulation_(simulation), control_(control)
{
  const auto serve = [&](const std::string & name, std::function<bool()> action) {
    const boost::function<bool(Empty::Request &, Empty::Response &)> callback =
      [action](Empty::Request &, Empty::Response &) { return action(); };
    servers_.push_back(node.advertiseService("/gazebo/" + name, callback));
  };
  serve("pause_physics", [this] { return setPaused(true); });
  serve("unpause_physics", [this] { return setPaused(false); });
  serve("reset_simulation", [restart] {
    restart();
    return true;
  });
  servers_.push_back(node.advertiseService("/gazebo/get_model_state", &GazeboServices::getModelState, this));
}

bool GazeboServices::setPaused(bool paused)
{
  control_.paused = paused;
  return true;
}

bool GazeboServices::getModelState(
  gazebo_msgs::GetModelState::Request & request, gazebo_msgs::GetModelState::Response & response)
{
  auto entity = find(simulation_, request.model_name);
  if (!entity) {
    response.status_message = "GetModelState: model [" + request.model_name + "] does not exist";
    return true;
  }
  if (!isWorld(request.relative_entity_name)) {
    const auto reference = find(simulation_, request.relative_entity_name);
    if (!reference) {
      response.status_message = "GetModelState: reference [" + request.relative_entity_name + "] does not exist";
      return true;
    }
    // As in Gazebo, the twist is turned into the reference frame, not made relative to its motion.
    entity->velocity = rotated(entity->velocity, -reference->pose.yaw);
    entity->pose = relativeTo(entity->pose, reference->pose);
  }
  response.header.stamp = toRosTime(simulation_.time());
  response.header.frame_id = request.relative_entity_name.empty() ? "world" : request.relative_entity_name;
  response.pose = toPose(entity->pose);
  response.twist = toTwist(entity->velocity, entity->yaw_rate);
  response.success = true;
  response.status_message = "GetModelState: got properties";
  return true;
}
}  // namespace f1tenth_sim2d
