#include "node/app/diagnostics_output.h"

#include <cstdio>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
using diagnostic_msgs::DiagnosticArray;
using diagnostic_msgs::DiagnosticStatus;
using diagnostic_msgs::KeyValue;

constexpr double kRate = 1.0;         // Hz
constexpr double kFastEnough = 0.95;  // of the factor that is asked for

KeyValue value(const std::string & key, const std::string & text)
{
  KeyValue entry;
  entry.key = key;
  entry.value = text;
  return entry;
}

std::string shown(double number)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", number);
  return text;
}

const char * modeOf(const TimeControl & control)
{
  if (control.is_lockstep) {
    return "lockstep";
  }
  return control.real_time_factor > 0.0 ? "paced" : "free";
}

/// Whether wall time and simulated time cannot be compared.
bool isDisturbed(const TimeControl & before, const TimeControl & after)
{
  return before.pauses != after.pauses || before.restarts != after.restarts ||
         before.real_time_factor != after.real_time_factor;
}
}  // namespace

DiagnosticsOutput::DiagnosticsOutput(
  ros::Publisher publisher, const TimeControl & control, std::function<std::vector<Fleet::Driver>()> drivers)
: MessageOutput(std::move(publisher), kRate), control_(control), drivers_(std::move(drivers)), seen_(control)
{
}

void DiagnosticsOutput::update(SimTime now, bool anyway)
{
  const ros::WallTime wall = ros::WallTime::now();
  factor_.reset();
  if (!isDisturbed(seen_, control_)) {
    factor_ = static_cast<double>(now - last_time_) * 1e-9 / (wall - last_wall_).toSec();
  }
  seen_ = control_;
  last_time_ = now;
  last_wall_ = wall;
  MessageOutput::update(now, anyway);
}

void DiagnosticsOutput::fill(diagnostic_msgs::DiagnosticArray & message, SimTime now)
{
  message.header.stamp = toRosTime(now);
  message.status.clear();
  message.status.push_back(timeStatus());
  for (const auto & driver : drivers_()) {
    message.status.push_back(commandStatus(driver));
  }
}

DiagnosticStatus DiagnosticsOutput::timeStatus() const
{
  DiagnosticStatus status;
  status.name = "sim2d: time";
  status.hardware_id = "sim2d";
  status.values = {value("mode", modeOf(control_))};
  const double wanted = control_.real_time_factor;
  if (wanted > 0.0) {
    status.values.push_back(value("wanted_real_time_factor", shown(wanted)));
  }
  if (!factor_) {
    status.message = "no real-time factor: time was paused, restarted or told another pace";
    return status;
  }
  status.values.push_back(value("real_time_factor", shown(*factor_)));
  status.message = "real-time factor " + shown(*factor_);
  if (wanted > 0.0 && *factor_ < kFastEnough * wanted) {
    status.level = DiagnosticStatus::WARN;
    status.message += ", cannot keep up with " + shown(wanted);
  }
  return status;
}

DiagnosticStatus DiagnosticsOutput::commandStatus(const Fleet::Driver & driver)
{
  DiagnosticStatus status;
  status.name = "sim2d: commands of " + driver.car;
  status.hardware_id = "sim2d";
  status.values = {
    value("accepted", std::to_string(driver.commands.accepted())),
    value("refused", std::to_string(driver.commands.refused()))};
  status.message = "OK";
  if (driver.commands.refused() > 0) {
    status.level = DiagnosticStatus::WARN;
    status.message = "refused: " + driver.commands.lastRefusal();
  }
  return status;
}
}  // namespace f1tenth_sim2d
