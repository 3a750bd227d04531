#include "f1tenth_navigation_mgr/navigation_mgr.h"

#include <ros/init.h>

#include <algorithm>
#include <iterator>

namespace f1tenth_navigation_mgr
{
namespace
{
const ros::WallDuration kSpinWait{0.01};

ros::Time rosNow()
{
  return ros::Time::isValid() ? ros::Time::now() : ros::Time{};
}
}  // namespace

NavigationMgr::NavigationMgr(const std::string & robot, const Timeouts & timeouts) : client_{robot, timeouts} {}

void NavigationMgr::LoadGoals(const std::string & path)
{
  const Goals goals = LoadGoalsFile(path, {"map", client_.OdomFrame()});
  queue_.insert(queue_.end(), goals.begin(), goals.end());
  empty_reported_ = false;
  AnnounceNext();
}

void NavigationMgr::AddGoal(const Goal & goal)
{
  queue_.push_back(goal);
  empty_reported_ = false;
  AnnounceNext();
}

void NavigationMgr::ClearGoals()
{
  queue_.resize(client_.HasGoal() ? 1 : 0);
  AnnounceNext();
}

void NavigationMgr::SetLoopMode(bool loop)
{
  loop_mode_ = loop;
  AnnounceNext();
}

// What follows the front of the queue.
Goals NavigationMgr::NextGoals() const
{
  Goals next{std::next(queue_.begin()), queue_.end()};
  if (loop_mode_) next.push_back(queue_.front());
  return next;
}

void NavigationMgr::AnnounceNext()
{
  if (client_.HasGoal()) client_.Announce(NextGoals());
}

SpinResult NavigationMgr::Spin()
{
  client_.Serve(kSpinWait);
  return SpinOnce(rosNow());
}

SpinResult NavigationMgr::Spin(const ros::Time & now)
{
  client_.Serve(ros::WallDuration{0.0});
  return SpinOnce(now);
}

SpinResult NavigationMgr::SpinOnce(const ros::Time & now)
{
  if (!CanSpin()) return SpinResult::kNotConnected;
  if (client_.HasGoal()) return CheckGoal(now);
  return queue_.empty() ? ReportEmpty() : SendFront(now);
}

bool NavigationMgr::CanSpin() const
{
  return client_.IsConnected() || client_.IsServerGone();
}

SpinResult NavigationMgr::CheckGoal(const ros::Time & now)
{
  const auto result = client_.Check(now);
  return result ? Finish(*result) : SpinResult::kDriving;
}

SpinResult NavigationMgr::SendFront(const ros::Time & now)
{
  client_.Send(queue_.front(), NextGoals(), now);
  return SpinResult::kSent;
}

const Goal & NavigationMgr::FrontGoalsQueue() const
{
  if (queue_.empty()) throw Error{"there is no goal in the queue"};
  return queue_.front();
}

SpinResult NavigationMgr::CheckGoalState()
{
  client_.Serve(kSpinWait);
  if (!client_.HasGoal()) return SpinResult::kIdle;
  return CanSpin() ? CheckGoal(rosNow()) : SpinResult::kNotConnected;
}

SpinResult NavigationMgr::SendGoal(const Goal & goal)
{
  if (client_.HasGoal()) throw Error{"a goal is active: it must be over before the next one is sent"};
  client_.Serve(kSpinWait);
  if (!client_.IsConnected()) return SpinResult::kNotConnected;
  if (queue_.empty() || !(queue_.front() == goal)) queue_.push_front(goal);
  empty_reported_ = false;
  return SendFront(rosNow());
}

SpinResult NavigationMgr::ReportEmpty()
{
  if (empty_reported_) return SpinResult::kIdle;
  empty_reported_ = true;
  return SpinResult::kQueueEmpty;
}

SpinResult NavigationMgr::Finish(const GoalResult & result)
{
  const bool reached = result.outcome == GoalOutcome::kSucceeded;
  results_.push_back(result);
  queue_.pop_front();
  if (reached && loop_mode_) queue_.push_back(result.goal);
  const auto & callback = reached ? on_reached_ : on_failed_;
  if (callback) callback(result);
  return reached ? SpinResult::kReached : SpinResult::kFailed;
}

bool NavigationMgr::WaitForServer(ros::WallDuration timeout)
{
  const auto end = ros::WallTime::now() + timeout;
  do {
    client_.Serve(std::min(kSpinWait, timeout));
    if (client_.IsConnected()) return true;
  } while (ros::ok() && ros::WallTime::now() < end);
  return false;
}

bool NavigationMgr::IsServerGone()
{
  client_.Serve(ros::WallDuration{0.0});
  return client_.IsServerGone();
}

void NavigationMgr::Cancel()
{
  client_.Cancel(ros::Time::now());
}

std::optional<Goal> NavigationMgr::GoalInFlight() const
{
  return client_.HasGoal() ? std::optional<Goal>{queue_.front()} : std::nullopt;
}
}  // namespace f1tenth_navigation_mgr
