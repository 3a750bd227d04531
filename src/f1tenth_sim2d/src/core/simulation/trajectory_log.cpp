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
  keepRecord();
  hash_.reset();
  periods_ = 0;
  touches_.clear();
  beginRecord();
}

void TrajectoryLog::beginRecord()
{
  if (record_file_.empty()) {
    return;
  }
  record_.open(record_file_, std::ios::trunc);
  record_.precision(17);
  requireGood();
  record_ << "time,car,x,y,yaw,v_x,v_y,yaw_rate,steering_angle,clearance,contacts,contact_speed,hash\n";
}

void TrajectoryLog::keepRecord()
{
  if (record_file_.empty()) {
    return;
  }
  if (!touches_.empty()) {
    writeRecord();
  }
  record_.close();
  requireGood();
  const std::string kept = record_file_ + ".before_reset_" + std::to_string(++restarts_);
  if (std::rename(record_file_.c_str(), kept.c_str()) != 0) {
    throw Error("record: cannot write " + kept + ": " + std::strerror(errno));
  }
}

void TrajectoryLog::writeRecord()
{
  if (record_file_.empty()) {
    return;
  }
  const std::string hash = hash_.hexDigest();
  for (const CarId car : simulation_.cars()) {
    const CarState state = simulation_.state(car);
    const auto found = touches_.find(car);
    const Touch touch = found != touches_.end() ? found->second : Touch{};
    record_ << seconds(simulation_.time()) << ',' << simulation_.car(car).name;
    for (const double number :
         {state.pose.x, state.pose.y, state.pose.yaw, state.velocity.x, state.velocity.y, state.yaw_rate,
          state.steering_angle, simulation_.clearance(car, kClearanceLimit)}) {
      record_ << ',' << number;
    }
    record_ << ',' << boost::algorithm::join(touch.models, ";") << ',' << touch.speed << ',' << hash << '\n';
  }
  record_.flush();
  requireGood();
}

void TrajectoryLog::requireGood() const
{
  if (!record_) {
    throw Error("record: cannot write " + record_file_ + ": " + std::strerror(errno));
  }
}
}  // namespace f1tenth_sim2d
