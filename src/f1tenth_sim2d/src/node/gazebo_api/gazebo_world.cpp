#include "node/gazebo_api/gazebo_world.h"

#include <cmath>
#include <utility>

#include "f1tenth_sim2d/errors.h"
#include "node/gazebo_api/gazebo_entities.h"
#include "node/parameters/limits.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kTolerance = 1e-9;  // of numbers that must stay as they are

bool differs(double a, double b)
{
  return !(std::abs(a - b) <= kTolerance * (1.0 + std::abs(b)));
}

/// What of the request cannot be done; empty if nothing.
std::string objection(const gazebo_msgs::SetPhysicsProperties::Request & request, double time_step, double gravity)
{
  const geometry_msgs::Vector3 & g = request.gravity;
  if (differs(request.time_step, time_step)) {
    return "time_step is " + toText(request.time_step) + ", this simulator keeps " + toText(time_step);
  }
  if (differs(g.x, 0.0) || differs(g.y, 0.0) || differs(g.z, -gravity)) {
    return "gravity is (" + toText(g.x) + ", " + toText(g.y) + ", " + toText(g.z) + "), this simulator keeps (0, 0, " +
           toText(-gravity) + ")";
  }
  if (!std::isfinite(request.max_update_rate) || !realTimeFactor().allows(request.max_update_rate * time_step)) {
    return "max_update_rate is " + toText(request.max_update_rate) +
           ", allowed is 0 (as fast as it goes) or at least " + toText(kLeastRealTimeFactor / time_step);
  }
  return "";
}
}  // namespace

GazeboWorld::GazeboWorld(
  ros::NodeHandle & node, const Simulation & simulation, TimeControl & control, Actions actions,
  InterventionLog & interventions)
: simulation_(simulation), control_(control), actions_(std::move(actions)), interventions_(interventions)
{
  serveEmpty(node, "pause_physics", [this] { control_.paused = true; });
  serveEmpty(node, "unpause_physics", [this] {
    control_.pauses += control_.paused ? 1 : 0;
    control_.paused = false;
  });
  serveEmpty(node, "reset_simulation", actions_.restart);
  serveEmpty(node, "reset_world", actions_.reset_poses);
  servers_.push_back(node.advertiseService("/gazebo/get_world_properties", &GazeboWorld::getWorld, this));
  servers_.push_back(node.advertiseService("/gazebo/get_physics_properties", &GazeboWorld::getPhysics, this));
  servers_.push_back(node.advertiseService("/gazebo/set_physics_properties", &GazeboWorld::setPhysics, this));
}

void GazeboWorld::serveEmpty(ros::NodeHandle & node, const std::string & name, const std::function<void()> & action)
{
  using Event = ros::ServiceEvent<std_srvs::Empty::Request, std_srvs::Empty::Response>;
  const boost::function<bool(Event &)> callback = [this, name, action](Event & event) {
    interventions_.add(simulation_.time(), {name, event.getCallerName(), ""});
    action();
    return true;
  };
  servers_.push_back(node.advertiseService("/gazebo/" + name, callback));
}

bool GazeboWorld::getWorld(GetWorld::Request & /*request*/, GetWorld::Response & response)
{
  response.sim_time = static_cast<double>(simulation_.time()) * 1e-9;
  for (const auto & entity : entities(simulation_)) {
    response.model_names.push_back(entity.name);
  }
  response.rendering_enabled = false;
  response.success = true;
  response.status_message = "GetWorldProperties: got properties";
  return true;
}

bool GazeboWorld::getPhysics(GetPhysics::Request & /*request*/, GetPhysics::Response & response)
{
  response.time_step = timeStepSec();
  response.pause = control_.paused;
  response.max_update_rate = control_.real_time_factor / timeStepSec();
  response.gravity.z = -simulation_.world().gravity;
  response.success = true;
  response.status_message = "GetPhysicsProperties: got properties";
  return true;
}

bool GazeboWorld::setPhysics(ros::ServiceEvent<SetPhysics::Request, SetPhysics::Response> & event)
{
  const SetPhysics::Request & request = event.getRequest();
  SetPhysics::Response & response = event.getResponse();
  std::string problem = objection(request, timeStepSec(), simulation_.world().gravity);
  if (problem.empty() && control_.is_lockstep && differs(request.max_update_rate, 0.0)) {
    problem = "max_update_rate must stay 0 in lockstep";
  }
  response.success = problem.empty();
  response.status_message = problem.empty() ? "physics engine updated" : "SetPhysicsProperties: " + problem;
  if (response.success && !control_.is_lockstep) {
    interventions_.add(simulation_.time(), {"set_physics_properties", event.getCallerName(), ""});
    control_.real_time_factor = request.max_update_rate * timeStepSec();
  }
  return true;
}
}  // namespace f1tenth_sim2d
