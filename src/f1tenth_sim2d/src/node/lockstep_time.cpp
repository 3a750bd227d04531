#include "lockstep_time.h"

#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include "stop_signal.h"

namespace f1tenth_sim2d
{
namespace
{
std::size_t subscriberCount()
{
  ros::V_string topics;
  ros::this_node::getAdvertisedTopics(topics);
  std::size_t count = 0;
  for (const auto & topic : topics) {
    count += ros::TopicManager::instance()->getNumSubscribers(topic);
  }
  return count;
}
}  // namespace

LockstepTime::LockstepTime(
  const Simulation & simulation, SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control,
  ClockPublisher & clock, LockstepBarrier & barrier)
: simulation_(simulation), world_(world), queue_(queue), control_(control), clock_(clock), barrier_(barrier)
{
}

void LockstepTime::advance()
{
  const int restarts = control_.restarts;
  queue_.callAvailable();
  if (control_.paused || control_.restarts != restarts) {
    return;
  }
  const SimTime end = world_.periodEnd();
  barrier_.open(end, world_.periods() + 1);
  subscribers_ = subscriberCount();
  world_.advanceTo(end);
  publishClock();
  barrier_.wait({[&] { return stopRequested() || control_.restarts != restarts; }, [this] { repeatPeriod(); }});
}

// Last: whoever has seen the period's time finds everything of the period in its inbox.
void LockstepTime::publishClock()
{
  drain_.drain();
  clock_.publish(world_.time());
}

// A driver that has answered would answer a second scan with a second command, so it gets none. The others' messages
// go out again only when somebody new is there: tf complains about a stamp that it knows.
void LockstepTime::repeatPeriod()
{
  for (CarIndex car = 0; car < simulation_.carCount(); ++car) {
    if (!barrier_.hasAnswered(simulation_.car(car).name)) {
      world_.repeatScans(car);
    }
  }
  const std::size_t subscribers = subscriberCount();
  if (subscribers != subscribers_) {
    subscribers_ = subscribers;
    world_.repeatOthers();
  }
  publishClock();
}

void LockstepTime::restart() {}
}  // namespace f1tenth_sim2d
