#include "node/transport/flow_control.h"

#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
// Messages of a topic. Far below what roscpp keeps, so that nothing is lost.
constexpr std::size_t kWaitAbove = 64;
constexpr std::size_t kGoOnBelow = 16;
const ros::WallDuration kLook{100e-6};
const ros::WallDuration kPatience{1.0};   // after which a warning names who is waited for
const ros::WallDuration kReminder{10.0};  // after which it is repeated
const ros::WallDuration kFarewell{2.0};   // at most, at the end
}  // namespace

FlowControl::FlowControl(Outbox & outbox, ros::CallbackQueue & queue, double silent_subscriber_sec)
: outbox_(outbox), queue_(queue), silent_subscriber_sec_(silent_subscriber_sec)
{
}

void FlowControl::waitForSubscribers(const std::function<bool()> & interrupted)
{
  if (outbox_.lagging(kWaitAbove).empty()) {
    return;
  }
  if (waits_) {
    const ros::WallTime start = ros::WallTime::now();
    waitUntilBelow(kGoOnBelow, interrupted);
    waited_sec_ += (ros::WallTime::now() - start).toSec();
  } else {
    noteLosses();
  }
}

void FlowControl::waitUntilBelow(std::size_t limit, const std::function<bool()> & interrupted)
{
  progress_.clear();
  for (auto topics = outbox_.lagging(limit); !topics.empty() && !interrupted(); topics = outbox_.lagging(limit)) {
    const ros::WallTime now = ros::WallTime::now();
    for (const auto & topic : topics) {
      const std::size_t in_flight = topic->inFlight();
      Progress & progress = progress_.try_emplace(topic->name(), Progress{in_flight, now}).first->second;
      if (progress.in_flight != in_flight) {
        progress = {in_flight, now};
      } else if (now - progress.since > ros::WallDuration(silent_subscriber_sec_)) {
        giveUp(*topic);
      } else if (now - progress.since > kPatience) {
        note(*topic);
      }
    }
    queue_.callAvailable(kLook);
  }
}

void FlowControl::drain()
{
  const ros::WallTime deadline = ros::WallTime::now() + kFarewell;
  while (!outbox_.lagging(0).empty() && ros::WallTime::now() < deadline) {
    kLook.sleep();
  }
}

void FlowControl::giveUp(Topic & topic)
{
  const std::string names = topic.thoseBehind();
  ROS_WARN(
    "%s has read nothing of %s for %g s: the simulation no longer waits for it", names.c_str(), topic.name().c_str(),
    silent_subscriber_sec_);
  slow_.insert(names + " (" + topic.name() + ", no longer waited for)");
  topic.giveUpThoseBehind();
}

void FlowControl::note(const Topic & topic)
{
  const std::string names = topic.thoseBehind();
  const ros::WallTime now = ros::WallTime::now();
  ros::WallTime & said = said_[topic.name()];
  if (now - said > kReminder) {
    ROS_WARN(
      "%s does not keep up with %s%s", names.c_str(), topic.name().c_str(),
      waits_ ? ": the simulation waits for it" : " and loses messages");
    said = now;
  }
  slow_.insert(names + " (" + topic.name() + ")");
}

void FlowControl::noteLosses()
{
  for (const auto & topic : outbox_.lagging(kWaitAbove)) {
    std::uint64_t & noted = losses_[topic->name()];
    if (topic->lost() != noted) {
      noted = topic->lost();
      note(*topic);
    }
  }
}

std::uint64_t FlowControl::lostMessages() const
{
  std::uint64_t lost = 0;
  for (const auto & [topic, counts] : outbox_.counts()) {
    lost += counts->lost;
  }
  return lost;
}

std::set<std::string> FlowControl::takeSlowSubscribers()
{
  return std::exchange(slow_, {});
}
}  // namespace f1tenth_sim2d
