#include "node/world/simulated_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace f1tenth_sim2d
{
template <typename Visit>
void SimulatedWorld::forEachOutput(Visit visit)
{
  for (const auto & [id, running] : running_) {
    for (const auto & output : running.outputs) {
      visit(running, *output);
    }
  }
}

SimulatedWorld::SimulatedWorld(
  Simulation & simulation, TransformBatch & transforms, double control_period_sec, const std::string & record_file)
: simulation_(simulation), transforms_(transforms), period_ns_(control_period_sec * 1e9), log_(simulation, record_file)
{
  schedule_.add(period_ns_, [this](SimTime) { log_.endPeriod(); });
}

Schedule::Id SimulatedWorld::schedule(Output & output, std::optional<CarId> car)
{
  const SimTime first_period_end = endOf(1);
  const double period_ns =
    output.rate() > 0.0 ? periodOf(output.rate()) : static_cast<double>(simulation_.stepLength());
  // In lockstep the first period is repeated for those who come late.
  if (car && output.isAnswered()) {
    answered_at_[*car] = time();
  }
  return schedule_.add(
    period_ns, [this, &output, car, first_period_end](SimTime now) { update(output, car, now <= first_period_end); },
    time());
}

void SimulatedWorld::update(Output & output, std::optional<CarId> car, bool anyway)
{
  output.update(time(), anyway);
  if (car && output.isAnswered()) {
    answered_at_[*car] = time();
  }
}

SimulatedWorld::OutputsId SimulatedWorld::add(const OutputList & outputs, std::optional<CarId> car)
{
  Running & running = running_.emplace(next_id_, Running{outputs, car, time(), {}}).first->second;
  for (const auto & output : outputs) {
    running.tasks.push_back(schedule(*output, car));
  }
  return next_id_++;
}

void SimulatedWorld::remove(OutputsId id)
{
  const auto found = running_.find(id);
  for (const Schedule::Id task : found->second.tasks) {
    schedule_.remove(task);
  }
  running_.erase(found);
}

SimTime SimulatedWorld::endOf(std::int64_t period) const
{
  return std::llround(static_cast<double>(period) * period_ns_);
}

SimTime SimulatedWorld::periodEnd() const
{
  return endOf(log_.periods() + 1);
}

void SimulatedWorld::finishPeriod()
{
  if (time() > endOf(log_.periods())) {
    advanceTo(periodEnd());
  }
}

void SimulatedWorld::advanceTo(SimTime end)
{
  while (simulation_.time() < end) {
    simulation_.advanceTo(std::min(end, schedule_.nextDue()));
    ros::Time::setNow(toRosTime(simulation_.time()));
    distributeContacts();
    schedule_.run(simulation_.time());
    transforms_.publish();
  }
}

void SimulatedWorld::distributeContacts()
{
  for (const CarId car : simulation_.cars()) {
    for (const auto & contact : simulation_.contacts(car)) {
      log_.note(car, contact);
    }
  }
  forEachOutput([this](const Running & running, Output & output) {
    if (running.car) {
      output.note(simulation_.contacts(*running.car));
    }
  });
  for (const CarId car : simulation_.cars()) {
    simulation_.clearContacts(car);
  }
}

void SimulatedWorld::measureFirst(CarId car)
{
  forEachOutput([&](const Running & running, Output & output) {
    const auto age_ns = static_cast<double>(time() - running.since);
    if (running.car == car && output.rate() > 0.0 && periodOf(output.rate()) > age_ns) {
      update(output, car, true);
    }
  });
}

bool SimulatedWorld::isToAnswer(CarId car, SimTime since) const
{
  const auto found = answered_at_.find(car);
  return found == answered_at_.end() || found->second > since;
}

void SimulatedWorld::repeatForDriver(CarId car)
{
  forEachOutput([car](const Running & running, Output & output) {
    if (running.car == car && output.isAnswered()) {
      output.repeat();
    }
  });
}

void SimulatedWorld::repeatOthers()
{
  forEachOutput([](const Running &, Output & output) {
    if (!output.isAnswered()) {
      output.repeat();
    }
  });
  transforms_.publish();
}

void SimulatedWorld::restart()
{
  log_.restart();
  simulation_.reset();
  schedule_.restart();
  for (auto & [car, time] : answered_at_) {
    time = 0;
  }
  for (auto & [id, running] : running_) {
    running.since = 0;
  }
  forgetContacts();
}

void SimulatedWorld::resetPoses()
{
  simulation_.resetPoses();
  forgetContacts();
}

void SimulatedWorld::forgetContacts()
{
  forEachOutput([](const Running &, Output & output) { output.restart(); });
}
}  // namespace f1tenth_sim2d
