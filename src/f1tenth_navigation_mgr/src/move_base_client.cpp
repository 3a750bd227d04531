#include "f1tenth_navigation_mgr/move_base_client.h"

namespace f1tenth_navigation_mgr
{
namespace
{
move_base_msgs::MoveBaseGoal toMessage(const Goal & goal, const ros::Time & stamp)
{
  move_base_msgs::MoveBaseGoal message;
  message.target_pose.header.frame_id = goal.frame_id;
  message.target_pose.header.stamp = stamp;
  auto & pose = message.target_pose.pose;
  pose.position.x = goal.x;
  pose.position.y = goal.y;
  pose.position.z = goal.z;
  pose.orientation.x = goal.qx;
  pose.orientation.y = goal.qy;
  pose.orientation.z = goal.qz;
  pose.orientation.w = goal.qw;
  return message;
}
}  // namespace

MoveBaseClient::MoveBaseClient(const std::string & ns, const Timeouts & timeouts) : timeouts_{timeouts}, nh_{ns} {}

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
  // The subscriptions of a process to one topic share one connection, made with the hints of the first. actionlib
  // gives none, and without TCP_NODELAY a small message may wait 40 ms in the sender: in lockstep, for many periods.
  Listen<actionlib_msgs::GoalStatusArray>("status", [this] {
    last_status_ = {ros::WallTime::now(), ros::Time::now()};
  });
  Listen<move_base_msgs::MoveBaseActionResult>("result", [] {});
  client_ = std::make_unique<Client>(nh_, "move_base", &queue_);
}

void MoveBaseClient::Serve(ros::WallDuration max_wait)
{
  if (!client_ && ros::Time::isValid()) Connect();
  queue_.callAvailable(max_wait);
  if (client_) WatchConnection();
}

void MoveBaseClient::WatchConnection()
{
  if (client_->isServerConnected()) {
    gone_since_.reset();
  } else if (!gone_since_) {
    gone_since_ = ros::WallTime::now();
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

void MoveBaseClient::Send(const Goal & goal, const ros::Time & now)
{
  const Moment moment{ros::WallTime::now(), now};
  last_status_ = moment;
  flight_ = Flight{client_->sendGoal(toMessage(goal, now)), goal, now, moment, moment.wall, {}, false};
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
