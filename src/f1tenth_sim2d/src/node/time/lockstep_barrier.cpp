#include "node/time/lockstep_barrier.h"

#include <ros/console.h>

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cstdio>
#include <utility>

#include "node/messages/output.h"

namespace f1tenth_sim2d
{
namespace
{
const ros::WallDuration kRepeatInterval{0.1};
// Of the timeout: after that a command that came too early, or late, is taken for the one that is missing.
constexpr double kStrayPatience = 0.5;
}  // namespace

ParticipantSilent::ParticipantSilent(std::string participant, const std::string & message)
: Error(message), participant_(std::move(participant))
{
}

LockstepBarrier::LockstepBarrier(
  ros::NodeHandle & node, ros::CallbackQueue & queue, LockstepOptions options, Impostor on_impostor)
: options_(std::move(options)), queue_(queue), ledger_(options_.participants), on_impostor_(std::move(on_impostor))
{
  using Event = ros::MessageEvent<const std_msgs::Header>;
  const boost::function<void(const Event &)> note = [this](const Event & event) { noteDone(event); };
  // Unlimited: a lost answer would never come again, and nobody sends more than a few per period.
  subscriber_ =
    node.subscribe<const Event &>("/sim2d/done", 0, note, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

void LockstepBarrier::noteDone(const ros::MessageEvent<const std_msgs::Header> & event)
{
  const std_msgs::Header & message = *event.getConstMessage();
  const std::string & node = event.getPublisherName();
  if (sim2d_lockstep::isParticipant(node, message.frame_id)) {
    ledger_.note(message.frame_id, message.stamp);
  } else if (takesPart(message.frame_id) && impostors_.emplace(node, message.frame_id).second) {
    ROS_WARN("lockstep: %s answers for %s, and is not believed", node.c_str(), message.frame_id.c_str());
    on_impostor_(node, message.frame_id);
  }
}

void LockstepBarrier::open(SimTime end, std::int64_t number)
{
  stamp_ = toRosTime(end);
  number_ = number;
  late_.clear();
  if (!started_) {
    first_ = stamp_;
    ledger_.startAgain(first_);
  }
}

bool LockstepBarrier::welcome(const std::string & car)
{
  if (takesPart(car)) {
    started_ = false;
    first_ = stamp_;
    ledger_.note(car, ros::Time());
  }
  return !started_;
}

std::function<void(const ros::Time &)> LockstepBarrier::driverOf(const std::string & car)
{
  return [this, car](const ros::Time & stamp) { noteCommand(car, stamp); };
}

// A driver that was slow to start answers the first scan as often as it was repeated, also when time has gone on.
void LockstepBarrier::noteCommand(const std::string & car, const ros::Time & stamp)
{
  if (started_ && !stamp.isZero() && stamp <= first_) {
    late_.insert(car);
    return;
  }
  surplus_[car] += hasAnswered(car) && stamp.isZero() ? 1 : 0;
  ledger_.note(car, stamp_);
}

// Without a stamp, such an answer may have been taken for that to the next scan; a driver that was then a scan behind,
// and keeps only the newest, has skipped one that nobody will answer. A driver whose stamps lag behind its scans is not
// late at all.
void LockstepBarrier::takeSurplus()
{
  for (const std::string & name : ledger_.missing(stamp_)) {
    if (surplus_[name] > 0 || late_.count(name) > 0) {
      ROS_WARN("lockstep: an answer of %s came too early or late and is taken for that to another scan", name.c_str());
      strays_.push_back({name, number_, stamp_.toSec()});
      surplus_[name] = 0;
      ledger_.note(name, stamp_);
    }
  }
}

bool LockstepBarrier::takesPart(const std::string & name) const
{
  const auto & names = options_.participants;
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool LockstepBarrier::hasAnswered(const std::string & participant) const
{
  const auto missing = ledger_.missing(stamp_);
  return takesPart(participant) && std::find(missing.begin(), missing.end(), participant) == missing.end();
}

void LockstepBarrier::excuse(const std::string & car)
{
  if (!hasAnswered(car)) {
    ledger_.note(car, stamp_);
  }
}

void LockstepBarrier::wait(const Hooks & hooks)
{
  const bool is_repeated = waitForAnswers(hooks);
  if (hooks.interrupted()) {
    return;
  }
  started_ = true;
  if (is_repeated) {
    settle();
  }
  drain_.drain();
  queue_.callAvailable();
}

bool LockstepBarrier::waitForAnswers(const Hooks & hooks)
{
  bool is_repeated = false;
  ros::WallTime start = ros::WallTime::now();
  ros::WallTime next_repeat = start + kRepeatInterval;
  while (!ledger_.allDone(stamp_) && !hooks.interrupted()) {
    queue_.callAvailable(kRepeatInterval);
    hooks.look();
    const ros::WallTime now = ros::WallTime::now();
    start = hooks.paused() ? now : start;
    if (now - start > ros::WallDuration(kStrayPatience * options_.timeout_sec)) {
      takeSurplus();
    }
    if (now - start > ros::WallDuration(timeoutSec()) && !ledger_.allDone(stamp_)) {
      fail();
    }
    if (!started_ && now >= next_repeat) {
      hooks.repeat();
      is_repeated = true;
      next_repeat = now + kRepeatInterval;
    }
  }
  return is_repeated;
}

// A driver that was slow to start answers each repetition, and a late answer must not count for the second period.
void LockstepBarrier::settle()
{
  const ros::WallTime end = ros::WallTime::now() + kRepeatInterval;
  while (ros::WallTime::now() < end) {
    queue_.callAvailable(kRepeatInterval);
  }
}

void LockstepBarrier::restart()
{
  ledger_.startAgain(ros::Time());
  surplus_.clear();
  started_ = false;
}

void LockstepBarrier::fail() const
{
  const auto missing = ledger_.missing(stamp_);
  char text[128];
  std::snprintf(
    text, sizeof text, " not answered period %lld (%.3f s of simulated time) within %g s",
    static_cast<long long>(number_), stamp_.toSec(), timeoutSec());
  const bool one = missing.size() == 1;
  throw ParticipantSilent(
    missing.front(), std::string("lockstep: ") + (one ? "participant " : "participants ") +
                       boost::algorithm::join(missing, ", ") + (one ? " has" : " have") + text);
}
}  // namespace f1tenth_sim2d
