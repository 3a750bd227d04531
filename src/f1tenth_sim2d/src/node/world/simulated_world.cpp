#include "node/world/simulated_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace f1tenth_sim2d
{
SimulatedWorld::SimulatedWorld(
  Simulation & simulation, TransformBatch & transforms, double control_period_sec, const std::string & record_file)
: simulation_(simulation), transforms_(transforms), period_ns_(control_period_sec * 1e9), log_(simulation, record_file)
{
  schedule_.add(period_ns_, [this](SimTime) { log_.endPeriod(); });
}

Schedule::Id SimulatedWorld::schedule(Output & output)
{
  const SimTime first_period_end = std::llround(period_ns_);
  // In lockstep the first period is repeated for those who come late.
  return schedule_.add(
    periodOf(output.rate()), [&output, first_period_end](SimTime now) { output.update(now, now <= first_period_end); },
    time());
}

void SimulatedWorld::addCar(CarId id, CarOutputs outputs)
{
  Car & car = cars_[id];
  car.outputs = std::move(outputs);
  car.tasks.reserve(car.outputs.scans.size() + car.outputs.bumpers.size() + car.outputs.others.size());
  const auto scheduleAll = [&](auto & list) {
    for (auto & output : list) {
      car.tasks.push_back(schedule(*output));
    }
  };
  scheduleAll(car.outputs.scans);
  scheduleAll(car.outputs.bumpers);
  scheduleAll(car.outputs.others);
}

void SimulatedWorld::removeCar(CarId car)
{
  const auto found = cars_.find(car);
  if (found == cars_.end()) {
    return;
  }
  for (const Schedule::Id task : found->second.tasks) {
    schedule_.remove(task);
  }
  cars_.erase(found);
}

void SimulatedWorld::add(std::unique_ptr<Output> output)
{
  schedule(*output);
  others_.push_back(std::move(output));
}

SimTime SimulatedWorld::periodEnd() const
{
  return std::llround(static_cast<double>(log_.periods() + 1) * period_ns_);
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
      for (auto & bumper : cars_[car].outputs.bumpers) {
        bumper->note(contact);
      }
    }
    simulation_.clearContacts(car);
  }
}

void SimulatedWorld::repeatScans(CarId car)
{
  for (auto & scan : cars_[car].outputs.scans) {
    scan->repeat();
  }
}

void SimulatedWorld::repeatOthers()
{
  for (auto & [id, car] : cars_) {
    for (auto & bumper : car.outputs.bumpers) {
      bumper->repeat();
    }
    for (auto & output : car.outputs.others) {
      output->repeat();
    }
  }
  for (auto & output : others_) {
    output->repeat();
  }
  transforms_.publish();
}

void SimulatedWorld::restart()
{
  simulation_.reset();
  schedule_.restart();
  log_.restart();
  forgetContacts();
}

void SimulatedWorld::resetPoses()
{
  simulation_.resetPoses();
  forgetContacts();
}

void SimulatedWorld::forgetContacts()
{
  for (auto & [id, car] : cars_) {
    for (auto & bumper : car.outputs.bumpers) {
      bumper->restart();
    }
  }
}
}  // namespace f1tenth_sim2d
