#include "node/time/lockstep_time.h"

#include "node/messages/output.h"
#include "node/time/stop_signal.h"

namespace f1tenth_sim2d
{
LockstepTime::LockstepTime(
  const Simulation & simulation, SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control,
  Outbox & outbox, FlowControl & flow, const TopicPublisher<rosgraph_msgs::Clock> & clock, LockstepBarrier & barrier)
: simulation_(simulation),
  world_(world),
  queue_(queue),
  control_(control),
  outbox_(outbox),
  flow_(flow),
  clock_(clock),
  barrier_(barrier)
{
}

void LockstepTime::advance()
{
  const int restarts = control_.restarts;
  const auto restarted = [&] { return control_.restarts != restarts; };
  const auto interrupted = [&] { return stopRequested() || control_.paused || restarted(); };
  queue_.callAvailable();
  flow_.waitForSubscribers(interrupted);
  if (interrupted()) {
    return;
  }
  const SimTime end = world_.periodEnd();
  const SimTime begin = world_.time();
  const bool is_first = world_.periods() == 0;
  barrier_.open(end, world_.periods() + 1);
  subscribers_ = outbox_.subscriberCount();
  world_.advanceTo(end);
  if (is_first) {
    // Who needs a sensor answers nothing before it has come, and time would not go on until it does.
    world_.measureSlowly();
  }
  excuseFrom(begin);
  publishClock();
  barrier_.wait({[&] { return stopRequested() || restarted(); }, [this] { repeatPeriod(); }});
}

// A lidar may scan more seldom than once a period.
void LockstepTime::excuseFrom(SimTime begin)
{
  for (const CarId car : simulation_.cars()) {
    if (!world_.isToAnswer(car, begin)) {
      barrier_.excuse(simulation_.car(car).name);
    }
  }
}

// Last: whoever has seen the period's time finds everything of the period in its inbox.
void LockstepTime::publishClock()
{
  drain_.drain();
  clock_.publish(toClock(world_.time()));
}

// A driver that has answered would answer a second scan with a second command, so it gets none. The others' messages
// go out again only when somebody new is there: tf complains about a stamp that it knows.
void LockstepTime::repeatPeriod()
{
  for (const CarId car : simulation_.cars()) {
    if (!barrier_.hasAnswered(simulation_.car(car).name)) {
      world_.repeatForDriver(car);
    }
  }
  const std::size_t subscribers = outbox_.subscriberCount();
  if (subscribers != subscribers_) {
    subscribers_ = subscribers;
    world_.repeatOthers();
  }
  publishClock();
}
}  // namespace f1tenth_sim2d
