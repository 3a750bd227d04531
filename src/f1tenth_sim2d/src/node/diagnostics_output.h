#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <memory>
#include <string>
#include <vector>

#include "command_input.h"
#include "flow_control.h"
#include "node_parameters.h"
#include "output.h"

namespace f1tenth_sim2d
{
/// `/diagnostics`, once per simulated second: how fast time really goes, who does not keep up with it, and
/// what drivers sent that was refused.
class DiagnosticsOutput : public MessageOutput<diagnostic_msgs::DiagnosticArray>
{
public:
  struct Driver
  {
    std::string car;
    const CommandInput & commands;
  };

  /// @param factor  that is asked for; only for paced time
  DiagnosticsOutput(
    TopicPublisher<diagnostic_msgs::DiagnosticArray> publisher, TimeMode mode, double factor,
    std::vector<Driver> drivers, FlowControl & flow);
  void update(SimTime now, bool anyway) override;

private:
  void fill(diagnostic_msgs::DiagnosticArray & message, SimTime now) override;
  diagnostic_msgs::DiagnosticStatus timeStatus() const;
  diagnostic_msgs::DiagnosticStatus subscriberStatus();
  static diagnostic_msgs::DiagnosticStatus commandStatus(const Driver & driver);

  const TimeMode mode_;
  const double wanted_factor_;
  const std::vector<Driver> drivers_;
  FlowControl & flow_;
  double factor_{0.0};
  SimTime last_time_{0};
  ros::WallTime last_wall_{ros::WallTime::now()};
};
}  // namespace f1tenth_sim2d
