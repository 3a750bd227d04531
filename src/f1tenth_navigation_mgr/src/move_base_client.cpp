#include "f1tenth_navigation_mgr/move_base_client.h"

#include <nav_msgs/Path.h>

#include <algorithm>

namespace f1tenth_navigation_mgr
{
namespace
{
constexpr double kMostPatience = 4.0;  // times Timeouts::reconnect

geometry_msgs::PoseStamped toMessage(const Goal & goal, const ros::Time & stamp)
{
  geometry_msgs::PoseStamped message;
  message.header.frame_id = goal.frame_id;
  message.header.stamp = stamp;
  message.pose.position.x = goal.x;
  message.pose.position.y = goal.y;
  message.pose.position.z = goal.z;
  message.pose.orientation.x = goal.qx;
  message.pose.orientation.y = goal.qy;
  message.pose.orientation.z = goal.qz;
  message.pose.orientation.w = goal.qw;
  return message;
}
}  // namespace

MoveBaseClient::MoveBaseClient(const std::string & ns, const Timeouts & timeouts)
: timeouts_{timeouts}, nh_{ns}, patience_{timeouts.reconnect}
{
}

std::string MoveBaseClient::OdomFrame() const
{
  return nh_.resolveName("odom", false).substr(1);
}

template <typename Message>
void MoveBaseClient::Listen(const std::string & topic, const std::function<void()> & heard)
{
  auto options = ros::SubscribeOptions::create<Message>(
    "move_base/" + topic, 1, [heard](const typename Message::ConstPtr &) { heard(); }, ros::VoidPtr{}, &queue_);
  options.transport_hints.tcpNoDelay();
  listeners_.push_back(nh_.subscribe(options));
}

void MoveBaseClient::Connect()
{
  // Existing topics go first: a topic that this process already has is not subscribed or advertised anew.
  client_.reset();
  listeners_.clear();
  goals_ahead_ = {};
  // The subscriptions of a process to one topic share one connection, made with the hints of the first. actionlib
  // gives none, and without TCP_NODELAY a small message may wait 40 ms in the sender: in lockstep, for many periods.
  Listen<actionlib_msgs::GoalStatusArray>("status", [this] {
    last_status_ = {ros::WallTime::now(), ros::Time::now()};
  });
  Listen<move_base_msgs::MoveBaseActionResult>("result", [] {});
  // Before the client, so that the server knows this topic when it gets the first goal.
  goals_ahead_ = nh_.advertise<nav_msgs::Path>("move_base/goals_ahead", 1, true);
  client_ = std::make_unique<Client>(nh_, "move_base", &queue_);
  connected_ = ros::WallTime::now();
}

void MoveBaseClient::Serve(ros::WallDuration max_wait)
{
  if (!client_ && ros::Time::isValid()) Connect();
  queue_.callAvailable(max_wait);
  if (client_) WatchConnection();
}

void MoveBaseClient::WatchConnection()
{
  const ros::WallTime now = ros::WallTime::now();
  if (client_->isServerConnected()) {
    gone_since_.reset();
    patience_ = timeouts_.reconnect;
    return;
  }
  if (!gone_since_) gone_since_ = now;
  // Two nodes that start at the same moment may miss each other for ever: rospy can take the master's answer to a
  // subscription, which is older, for newer than the master's update, and roscpp asks a publisher only once.
  if (!flight_ && (now - connected_).toSec() > patience_) {
    // Growing, so that a machine on which connecting takes longer gets there, too.
    patience_ = std::min(2.0 * patience_, kMostPatience * timeouts_.reconnect);
    Connect();
  }
}

bool MoveBaseClient::IsConnected() const
{
  return client_ && !gone_since_;
}

bool MoveBaseClient::IsServerGone() const
{
  return flight_ && gone_since_ && (ros::WallTime::now() - *gone_since_).toSec() > timeouts_.disconnect;
}

void MoveBaseClient::Send(const Goal & goal, const Goals & next, const ros::Time & now)
{
  const Moment moment{ros::WallTime::now(), now};
  last_status_ = moment;
  flight_ = Flight{{}, goal, now, moment, moment.wall, {}, false};
  Announce(next);
  move_base_msgs::MoveBaseGoal message;
  message.target_pose = toMessage(goal, now);
  flight_->handle = client_->sendGoal(message);
}

void MoveBaseClient::Announce(const Goals & next)
{
  nav_msgs::Path ahead;
  ahead.header.stamp = flight_->sent;
  ahead.header.frame_id = flight_->goal.frame_id;
  ahead.poses.push_back(toMessage(flight_->goal, flight_->sent));
  for (const Goal & goal : next) ahead.poses.push_back(toMessage(goal, flight_->sent));
  goals_ahead_.publish(ahead);
}

void MoveBaseClient::Cancel(const ros::Time & now)
{
  if (!flight_ || flight_->cancelled) return;
  flight_->cancelled = true;
  // Not before the goal is acknowledged: actionlib would take the next status without it for a loss, and the goal
  // might still arrive, with nobody to watch it. Check() cancels it then.
  if (flight_->handle.getCommState() != actionlib::CommState::WAITING_FOR_GOAL_ACK) SendCancel(now);
}

void MoveBaseClient::SendCancel(const ros::Time & now)
{
  flight_->asked = {ros::WallTime::now(), now};
  flight_->last_attempt = flight_->asked.wall;
  flight_->handle.cancel();
}
}  // namespace f1tenth_navigation_mgr
