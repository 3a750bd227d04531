// The part of MoveBaseClient that judges the goal in flight.
#include <sstream>

#include "f1tenth_navigation_mgr/move_base_client.h"

namespace f1tenth_navigation_mgr
{
namespace
{
using actionlib::CommState;
using actionlib::TerminalState;

GoalOutcome toOutcome(const TerminalState & state)
{
  switch (state.state_) {
    case TerminalState::SUCCEEDED:
      return GoalOutcome::kSucceeded;
    case TerminalState::ABORTED:
      return GoalOutcome::kAborted;
    case TerminalState::REJECTED:
      return GoalOutcome::kRejected;
    case TerminalState::PREEMPTED:
    case TerminalState::RECALLED:
      return GoalOutcome::kPreempted;
    default:
      return GoalOutcome::kLost;
  }
}

std::string lossText(const std::string & action, const std::string & what, double seconds)
{
  std::ostringstream text;
  text << action << " " << what << " for " << seconds << " s";
  return text.str();
}
}  // namespace

bool MoveBaseClient::BothPassed(const Moment & since, const Moment & now, double seconds)
{
  return (now.wall - since.wall).toSec() > seconds && (now.ros - since.ros).toSec() > seconds;
}

std::optional<GoalResult> MoveBaseClient::Check(const ros::Time & now)
{
  if (!flight_) return {};
  const Moment moment{ros::WallTime::now(), now};
  switch (flight_->handle.getCommState().state_) {
    case CommState::DONE:
      return EndAsServerSays(now);
    case CommState::WAITING_FOR_RESULT:
      if (IsResultOverdue(moment)) return EndAsServerSays(now);
      break;
    case CommState::WAITING_FOR_GOAL_ACK:
    case CommState::WAITING_FOR_CANCEL_ACK:
      if (BothPassed(flight_->asked, moment, timeouts_.acknowledge)) {
        return EndAsLost("took no notice of the goal or its cancellation", timeouts_.acknowledge, now);
      }
      AskAgain(moment.wall);
      break;
    case CommState::PENDING:
    case CommState::ACTIVE:
      if (flight_->cancelled) SendCancel(now);
      break;
    default:
      break;
  }
  return CheckAlive(moment);
}

bool MoveBaseClient::IsResultOverdue(const Moment & now)
{
  if (!flight_->over_since) flight_->over_since = now.wall;
  return (now.wall - *flight_->over_since).toSec() > timeouts_.result;
}

void MoveBaseClient::AskAgain(const ros::WallTime & now)
{
  if ((now - flight_->last_attempt).toSec() < timeouts_.resend) return;
  flight_->last_attempt = now;
  if (flight_->handle.getCommState() == CommState::WAITING_FOR_CANCEL_ACK) {
    flight_->handle.cancel();
  } else {
    flight_->handle.resend();
  }
}

std::optional<GoalResult> MoveBaseClient::CheckAlive(const Moment & now)
{
  if (IsServerGone()) return EndAsLost("has been gone", timeouts_.disconnect, now.ros);
  if (BothPassed(last_status_, now, timeouts_.silence)) {
    return EndAsLost("has published no status", timeouts_.silence, now.ros);
  }
  return {};
}

GoalResult MoveBaseClient::EndAsServerSays(const ros::Time & now)
{
  const TerminalState state = flight_->handle.getTerminalState();
  const bool forgotten = toOutcome(state) == GoalOutcome::kLost && state.getText().empty();
  return End(toOutcome(state), forgotten ? ActionName() + " no longer knows the goal" : state.getText(), now);
}

GoalResult MoveBaseClient::EndAsLost(const std::string & what, double seconds, const ros::Time & now)
{
  // Should the server come back to life, it must not drive on towards a goal that nobody watches.
  flight_->handle.cancel();
  return End(GoalOutcome::kLost, lossText(ActionName(), what, seconds), now);
}

GoalResult MoveBaseClient::End(GoalOutcome outcome, const std::string & text, const ros::Time & now)
{
  GoalResult result{flight_->goal, outcome, text, flight_->sent, now};
  flight_.reset();
  return result;
}
}  // namespace f1tenth_navigation_mgr
