#include "node/time/lockstep_time.h"

#include <algorithm>

#include "node/messages/output.h"
#include "node/time/stop_signal.h"

namespace f1tenth_sim2d
{
LockstepTime::LockstepTime(
  const Simulation & simulation, SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control,
  const Advertiser & advertiser, const ros::Publisher & clock, LockstepBarrier & barrier)
: simulation_(simulation),
  world_(world),
  queue_(queue),
  control_(control),
  advertiser_(advertiser),
  clock_(clock),
  barrier_(barrier)
{
}

void LockstepTime::advance()
{
  const int restarts = control_.restarts;
  const auto restarted = [&] { return control_.restarts != restarts; };
  queue_.callAvailable();
  if (stopRequested() || control_.paused || restarted()) {
    return;
  }
  const SimTime end = world_.periodEnd();
  const SimTime begin = world_.time();
  if (world_.periods() == 0) {
    for (auto & [name, car] : cars_) {
      car.reset();
    }
  }
  barrier_.open(end, world_.periods() + 1);
  arrivals_ = advertiser_.arrivals();
  world_.advanceTo(end);
  lookAtCars(begin);
  publishClock();
  const auto look = [&] {
    if (!restarted()) {
      lookAtCars(begin);
    }
  };
  barrier_.wait(
    {[&] { return stopRequested() || restarted(); }, [this] { return control_.paused; }, look,
     [this] { repeatPeriod(); }});
}

void LockstepTime::lookAtCars(SimTime begin)
{
  const auto present = simulation_.cars();
  for (const CarId car : present) {
    const std::string & name = simulation_.car(car).name;
    greet(name, car);
    // A lidar may scan less often than once per period.
    if (!world_.isToAnswer(car, begin)) {
      barrier_.excuse(name);
    }
  }
  for (const auto & [name, car] : cars_) {
    if (!car || std::find(present.begin(), present.end(), *car) == present.end()) {
      barrier_.excuse(name);
    }
  }
}

// A participant that needs a sensor of a car does not answer before it has data, and time would not go on until then.
void LockstepTime::greet(const std::string & name, CarId car)
{
  std::optional<CarId> & known = cars_[name];
  if (known != car) {
    known = car;
    if (barrier_.welcome(name)) {
      world_.measureFirst(car);
    }
  }
}

// Published last: whoever has seen the period's time finds everything of the period in its inbox.
void LockstepTime::publishClock()
{
  drain_.drain();
  clock_.publish(toClock(world_.time()));
}

// A driver that has answered would answer a second scan with a second command, so it gets none. The others' messages
// go out again only when somebody new is there: tf complains about a repeated stamp.
void LockstepTime::repeatPeriod()
{
  for (const CarId car : simulation_.cars()) {
    if (!barrier_.hasAnswered(simulation_.car(car).name)) {
      world_.repeatForDriver(car);
    }
  }
  if (arrivals_ != advertiser_.arrivals()) {
    arrivals_ = advertiser_.arrivals();
    world_.repeatOthers();
  }
  publishClock();
}
}  // namespace f1tenth_sim2d
