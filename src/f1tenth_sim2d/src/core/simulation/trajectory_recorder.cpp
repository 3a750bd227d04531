#include "core/simulation/trajectory_recorder.h"

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

std::string columnsOf(const Touch & touch)
{
  char speed[32];
  std::snprintf(speed, sizeof speed, "%.17g", touch.speed);
  return boost::algorithm::join(touch.models, ";") + ',' + speed;
}

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

TrajectoryRecorder::TrajectoryRecorder(const std::string & file) : file_(file)
{
  open();
}

void TrajectoryRecorder::open()
{
  stream_.open(file_, std::ios::trunc);
  requireGood();
  stream_ << "time,car,x,y,yaw,v_x,v_y,yaw_rate,steering_angle,clearance,contacts,contact_speed,hash\n";
}

void TrajectoryRecorder::restart()
{
  stream_.close();
  open();
}

void TrajectoryRecorder::write(const Simulation & simulation, const Touches & touches, const std::string & hash)
{
  for (const CarId car : simulation.cars()) {
    const auto touch = touches.find(car);
    stream_ << seconds(simulation.time()) << ',' << simulation.car(car).name << ','
            << numbers(simulation.state(car), simulation.clearance(car, kClearanceLimit)) << ','
            << columnsOf(touch == touches.end() ? Touch{} : touch->second) << ',' << hash << '\n';
  }
  requireGood();
}

void TrajectoryRecorder::flush()
{
  stream_.flush();
  requireGood();
}

void TrajectoryRecorder::requireGood() const
{
  if (!stream_) {
    throw Error("record: cannot write " + file_ + ": " + std::strerror(errno));
  }
}
}  // namespace f1tenth_sim2d
