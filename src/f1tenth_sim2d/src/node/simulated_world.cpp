#include "simulated_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace f1tenth_sim2d
{
SimulatedWorld::SimulatedWorld(
  Simulation & simulation, TransformBatch & transforms, double control_period_sec, const std::string & record_file)
: simulation_(simulation),
  transforms_(transforms),
  period_ns_(control_period_sec * 1e9),
  log_(simulation, record_file),
  scans_(simulation.carCount()),
  bumpers_(simulation.carCount())
{
  schedule_.add(period_ns_, [this](SimTime) { log_.endPeriod(); });
}

void SimulatedWorld::schedule(Output & output)
{
  const SimTime first_period_end = std::llround(period_ns_);
  // In lockstep the first period is repeated for those who come late.
  schedule_.add(
    periodOf(output.rate()), [&output, first_period_end](SimTime now) { output.update(now, now <= first_period_end); });
}

void SimulatedWorld::addScan(CarIndex car, std::unique_ptr<ScanOutput> output)
{
  schedule(*output);
  scans_[car].push_back(std::move(output));
}

void SimulatedWorld::addBumper(CarIndex car, std::unique_ptr<BumperOutput> output)
{
  schedule(*output);
  bumpers_[car].push_back(std::move(output));
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
  for (CarIndex car = 0; car < simulation_.carCount(); ++car) {
    for (const auto & contact : simulation_.contacts(car)) {
      log_.note(car, contact);
      for (auto & bumper : bumpers_[car]) {
        bumper->note(contact);
      }
    }
    simulation_.clearContacts(car);
  }
}

void SimulatedWorld::repeatScans(CarIndex car)
{
  for (auto & scan : scans_[car]) {
    scan->repeat();
  }
}

void SimulatedWorld::repeatOthers()
{
  for (auto & bumpers : bumpers_) {
    for (auto & bumper : bumpers) {
      bumper->repeat();
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
  for (auto & bumpers : bumpers_) {
    for (auto & bumper : bumpers) {
      bumper->restart();
    }
  }
}
}  // namespace f1tenth_sim2d
