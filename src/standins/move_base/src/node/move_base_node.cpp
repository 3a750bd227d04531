#include "move_base_node.h"

#include <geometry_msgs/Twist.h>
#include <move_base_msgs/MoveBaseActionGoal.h>
#include <move_base_msgs/RecoveryStatus.h>
#include <ros/console.h>
#include <ros/this_node.h>
#include <workspace_support/lidar_inputs.h>

#include <algorithm>
#include <future>
#include <iterator>
#include <memory>
#include <utility>

#include "conversions.h"

namespace move_base
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

template <class Message>
ros::Subscriber subscribePromptly(ros::NodeHandle & node, const std::string & topic)
{
  const boost::function<void(const boost::shared_ptr<const Message> &)> ignore = [](const auto &) {};
  return node.subscribe<Message>(topic, 50, ignore, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

std::future<PlanAnswer> runBeside(std::function<PlanAnswer()> job)
{
  return std::async(std::launch::async, std::move(job));
}

// Two goals at one place are told apart by when they were sent.
bool startsWith(const nav_msgs::Path & goals, const geometry_msgs::PoseStamped & goal)
{
  if (goals.poses.empty()) {
    return false;
  }
  const geometry_msgs::PoseStamped & first = goals.poses.front();
  return first.header.stamp == goal.header.stamp && first.header.frame_id == goal.header.frame_id &&
         first.pose == goal.pose;
}
}  // namespace

MoveBaseNode::MoveBaseNode(MoveBaseSetup setup, ros::CallbackQueue & queue)
: parameters_(std::move(setup.parameters)),
  queue_(queue),
  node_(servedBy(queue)),
  private_node_(node_, ros::this_node::getName()),
  perception_(node_, parameters_),
  navigator_(
    parameters_.navigator, std::move(setup.global_planner), std::move(setup.local_planner),
    parameters_.lockstep ? PlanWorker() : PlanWorker(runBeside)),
  displays_(private_node_, parameters_, perception_),
  services_(private_node_, parameters_, perception_, navigator_),
  diagnostics_(node_, parameters_.base_frame),
  velocity_publisher_(node_.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
  goal_publisher_(private_node_.advertise<geometry_msgs::PoseStamped>("current_goal", 1)),
  recovery_publisher_(node_.advertise<move_base_msgs::RecoveryStatus>("move_base/recovery_status", 1)),
  action_goal_publisher_(node_.advertise<move_base_msgs::MoveBaseActionGoal>("move_base/goal", 1)),
  // actionlib asks for no hints, and without one a publisher waits for more to send (Nagle). Subscribers of a topic share
  // the connections of the first one, which is this.
  prompt_goals_(subscribePromptly<move_base_msgs::MoveBaseActionGoal>(node_, "move_base/goal")),
  prompt_cancels_(subscribePromptly<actionlib_msgs::GoalID>(node_, "move_base/cancel")),
  server_(std::make_unique<Server>(node_, "move_base", false))
{
  simple_goal_subscriber_ = node_.subscribe("move_base_simple/goal", 1, &MoveBaseNode::relayGoal, this);
  goals_ahead_subscriber_ =
    node_.subscribe("move_base/goals_ahead", 1, &MoveBaseNode::onGoalsAhead, this, ros::TransportHints().tcpNoDelay());
}

void MoveBaseNode::handleCallbacks()
{
  // A relayed goal comes back to this queue.
  while (!queue_.isEmpty()) {
    queue_.callAvailable();
  }
}

void MoveBaseNode::cycle(const ros::Time & now)
{
  watchClock(now);
  renewServer();
  if (!ready()) {
    if (server_is_up_) {
      updateGoal(now);
    }
    diagnostics_.tell(DiagnosticStatus::WARN, "Waiting for " + missing(), now);
    return;
  }
  startServer();
  if (!due(now)) {
    return;
  }
  if (navigator_.drives() || !parameters_.shutdown_costmaps) {
    perception_.updateCostmap(navigator_);
  }
  updateGoal(now);
  drive(now);
}

// A goal that could only wait could not be cancelled: whoever waits for the server waits for the map, too.
void MoveBaseNode::startServer()
{
  if (!server_is_up_) {
    server_is_up_ = true;
    server_->start();
    held_topics_ = {
      node_.advertise<move_base_msgs::MoveBaseActionResult>("move_base/result", 1),
      node_.advertise<move_base_msgs::MoveBaseActionFeedback>("move_base/feedback", 1),
      node_.advertise<actionlib_msgs::GoalStatusArray>("move_base/status", 1)};
  }
}

bool MoveBaseNode::due(const ros::Time & now)
{
  // Half a millisecond early counts: a stamp is not a multiple of the period to the last bit.
  const ros::Duration tolerance(0.0005);
  const ros::Duration period(parameters_.controller_period);
  if (last_cycle_ && now - *last_cycle_ + tolerance < period) {
    return false;
  }
  // One that comes a little late does not make those after it late as well.
  const bool late = !last_cycle_ || now - *last_cycle_ >= period + period;
  last_cycle_ = late ? now : *last_cycle_ + period;
  return true;
}

void MoveBaseNode::watchClock(const ros::Time & now)
{
  if (now_ && now < *now_) {
    ROS_WARN("Time jumped back: everything measured before is forgotten");
    perception_.startAgain();
    last_cycle_.reset();
    time_jumped_back_ = true;
    if (server_->isActive()) {
      abort("Aborting on goal because time jumped back");
    } else if (navigator_.drives()) {
      navigator_.cancel();
      publishZero();
    }
  }
  now_ = now;
}

// actionlib refuses what is older than its last goal: after a jump back, no goal would be taken for as long as time ran
// before. Another server knows of no goal.
void MoveBaseNode::renewServer()
{
  if (!time_jumped_back_ || server_->isActive() || server_->isNewGoalAvailable()) {
    return;
  }
  time_jumped_back_ = false;
  server_.reset();
  server_ = std::make_unique<Server>(node_, "move_base", false);
  if (server_is_up_) {
    server_->start();
  }
}

void MoveBaseNode::updateGoal(const ros::Time & now)
{
  const auto goal = server_->isNewGoalAvailable() ? server_->acceptNewGoal() : nullptr;
  if ((goal || server_->isActive()) && server_->isPreemptRequested()) {
    navigator_.cancel();
    publishZero();
    server_->setPreempted();
  } else if (goal) {
    accept(goal->target_pose, now);
  }
}

void MoveBaseNode::accept(const geometry_msgs::PoseStamped & target, const ros::Time & now)
{
  if (!isPlanar(target.pose.orientation)) {
    abort("Aborting on goal because it was sent with an invalid quaternion");
    return;
  }
  try {
    const Pose2 goal = perception_.inMap(target);
    goal_publisher_.publish(toPoseStamped(goal, headerOf(parameters_.global_frame, now)));
    target_ = target;
    failure_.clear();
    const std::vector<Pose2> next = nextGoals();
    warned_of_goals_ = warned_of_goals_ && navigator_.drives();
    warnOfGoals(next);
    navigator_.setGoal(goal, now.toSec(), next);
  } catch (const tf2::TransformException & error) {
    abort(
      "Aborting on goal because it cannot be transformed from frame \"" + target.header.frame_id + "\" to \"" +
      parameters_.global_frame + "\": " + error.what());
  }
}

void MoveBaseNode::onGoalsAhead(const nav_msgs::Path::ConstPtr & goals)
{
  goals_ahead_ = goals;
  if (navigator_.active() && startsWith(*goals, target_)) {
    const std::vector<Pose2> next = nextGoals();
    warnOfGoals(next);
    navigator_.setNextGoals(next);
  }
}

std::vector<Pose2> MoveBaseNode::nextGoals() const
{
  std::vector<Pose2> next;
  if (!goals_ahead_ || !startsWith(*goals_ahead_, target_)) {
    return next;
  }
  try {
    const auto & poses = goals_ahead_->poses;
    std::transform(std::next(poses.begin()), poses.end(), std::back_inserter(next), [this](const auto & pose) {
      return perception_.inMap(pose);
    });
    return next;
  } catch (const tf2::TransformException & error) {
    ROS_WARN("Stopping at the goal, because the goals ahead of it are not known in the map: %s", error.what());
    return {};
  }
}

// When the car sets off, not when it is on its way to them; they and the goal may come in either order.
void MoveBaseNode::warnOfGoals(const std::vector<Pose2> & goals)
{
  if (std::exchange(warned_of_goals_, warned_of_goals_ || !goals.empty())) {
    return;
  }
  for (const Pose2 & goal : goals) {
    const bool is_free = perception_.costmap().clearance(goal) >= 0.0;
    if (const std::string wrong = is_free ? "" : wrongWith(goal, perception_.costmap()); !wrong.empty()) {
      ROS_WARN("Of the goals to come, the one at (%.2f, %.2f): %s", goal.x, goal.y, wrong.c_str());
    }
  }
}

void MoveBaseNode::abort(const std::string & text)
{
  ROS_ERROR("%s", text.c_str());
  failure_ = text;
  navigator_.cancel();
  publishZero();
  server_->setAborted(move_base_msgs::MoveBaseResult(), text);
}

void MoveBaseNode::drive(const ros::Time & now)
{
  const CycleInput input = perception_.input(now);
  CycleOutput output = navigator_.cycle(input, perception_.costmap());
  if (!input.sensors_current && navigator_.active()) {
    output.trouble =
      "The car brakes or stands still because " + perception_.stale(now) +
      " is missing, or its stamp is too old or in the future. On a slow machine, start with real_time_factor:=0.5.";
  }
  publish(output, input, now);
  report(output, input, now);
  if (output.outcome) {
    finish(*output.outcome);
  }
  diagnose(output, now);
}

void MoveBaseNode::diagnose(const CycleOutput & output, const ros::Time & now)
{
  if (!navigator_.active() && !failure_.empty()) {
    diagnostics_.tell(DiagnosticStatus::ERROR, failure_, now);
  } else if (!output.trouble.empty()) {
    diagnostics_.tell(DiagnosticStatus::WARN, output.trouble, now);
  } else {
    diagnostics_.tell(DiagnosticStatus::OK, navigator_.active() ? "Driving to the goal" : "No goal", now);
  }
}

void MoveBaseNode::publish(const CycleOutput & output, const CycleInput & input, const ros::Time & now)
{
  if (const auto & command = output.command) {
    const double angle = command->steeringAngle(parameters_.wheelbase);
    geometry_msgs::Twist twist;
    twist.linear.x = command->speed;
    twist.angular.z = parameters_.cmd_angle_instead_rotvel ? angle : command->yawRate();
    velocity_publisher_.publish(twist);
  }
  if (output.new_plan) {
    displays_.showGlobalPlan(navigator_.way(), now);
  }
  displays_.showLocalPlan(output.prediction, now);
  displays_.showSurroundings(input.car.pose, now);
}

void MoveBaseNode::report(const CycleOutput & output, const CycleInput & input, const ros::Time & now)
{
  const auto pose = toPoseStamped(input.car.pose, headerOf(parameters_.global_frame, now));
  if (server_->isActive()) {
    move_base_msgs::MoveBaseFeedback feedback;
    feedback.base_position = pose;
    server_->publishFeedback(feedback);
  }
  if (!output.trouble.empty()) {
    ROS_WARN_THROTTLE(1.0, "%s", output.trouble.c_str());
  }
  if (output.recovery) {
    ROS_WARN(
      "Recovery behavior %u of %u: %s", output.recovery->number + 1, output.recovery->total,
      output.recovery->name.c_str());
    move_base_msgs::RecoveryStatus status;
    status.pose_stamped = pose;
    status.current_recovery_number = static_cast<std::uint16_t>(output.recovery->number);
    status.total_number_of_recoveries = static_cast<std::uint16_t>(output.recovery->total);
    status.recovery_behavior_name = output.recovery->name;
    recovery_publisher_.publish(status);
  }
}

void MoveBaseNode::finish(const Outcome & outcome)
{
  if (outcome.succeeded) {
    server_->setSucceeded(move_base_msgs::MoveBaseResult(), outcome.text);
  } else {
    ROS_ERROR("%s", outcome.text.c_str());
    failure_ = outcome.text;
    server_->setAborted(move_base_msgs::MoveBaseResult(), outcome.text);
  }
}

void MoveBaseNode::publishZero()
{
  velocity_publisher_.publish(geometry_msgs::Twist());
}

void MoveBaseNode::relayGoal(const geometry_msgs::PoseStamped::ConstPtr & target)
{
  move_base_msgs::MoveBaseActionGoal action_goal;
  action_goal.header.stamp = ros::Time::now();
  action_goal.goal.target_pose = *target;
  action_goal_publisher_.publish(action_goal);
}
}  // namespace move_base
