#include "core/simulation/trajectory_log.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kClearanceLimit = 5.0;  // m
constexpr SimTime kSecond = 1000000000;  // ns

std::string numbers(const CarState & state, double clearance)
{
  char text[256];
  std::snprintf(
    text, sizeof text, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", state.pose.x, state.pose.y, state.pose.yaw,
    state.velocity.x, state.velocity.y, state.yaw_rate, state.steering_angle, clearance);
  return text;
}

std::string seconds(SimTime time)
{
  char text[32];
  std::snprintf(
    text, sizeof text, "%lld.%09lld", static_cast<long long>(time / kSecond), static_cast<long long>(time % kSecond));
  return text;
}
}  // namespace

TrajectoryLog::TrajectoryLog(const Simulation & simulation, const std::string & record_file)
: simulation_(simulation), record_file_(record_file)
{
  beginRecord();
}

void TrajectoryLog::note(CarId car, const Contact & contact)
{
  Touch & touch = touches_[car];
  touch.models.insert(contact.other_model);
  touch.speed = std::max(touch.speed, contact.speed);
}

void TrajectoryLog::endPeriod()
{
  hash_.add(simulation_);
  ++periods_;
  writeRecord();
  touches_.clear();
}

void TrajectoryLog::restart()
{
  hash_.reset();
  periods_ = 0;
  touches_.clear();
  beginRecord();
}

void TrajectoryLog::flush()
{
  record_.flush();
  requireGood();
}

void TrajectoryLog::beginRecord()
{
  if (record_file_.empty()) {
    return;
  }
  // First what is still in memory of a run before, or it would be written into the new record.
  record_.close();
  record_.open(record_file_, std::ios::trunc);
  requireGood();
  record_ << "time,car,x,y,yaw,v_x,v_y,yaw_rate,steering_angle,clearance,contacts,contact_speed,hash\n";
}

void TrajectoryLog::writeRecord()
{
  if (record_file_.empty()) {
    return;
  }
  const std::string hash = hash_.hexDigest();
  for (const CarId car : simulation_.cars()) {
    const auto touch = touches_.find(car);
    record_ << seconds(simulation_.time()) << ',' << simulation_.car(car).name << ','
            << numbers(simulation_.state(car), simulation_.clearance(car, kClearanceLimit)) << ','
            << columnsOf(touch != touches_.end() ? touch->second : Touch{}) << ',' << hash << '\n';
  }
  requireGood();
}

std::string TrajectoryLog::columnsOf(const Touch & touch)
{
  char speed[32];
  std::snprintf(speed, sizeof speed, "%.17g", touch.speed);
  return boost::algorithm::join(touch.models, ";") + ',' + speed;
}

void TrajectoryLog::requireGood() const
{
  if (!record_) {
    throw Error("record: cannot write " + record_file_ + ": " + std::strerror(errno));
  }
}
}  // namespace f1tenth_sim2d
