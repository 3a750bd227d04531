#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <memory>
#include <string>
#include <vector>

#include "command_input.h"
#include "node_parameters.h"
#include "output.h"

namespace f1tenth_sim2d
{
/// `/diagnostics`, once per simulated second: how fast time really goes, and what drivers sent that was refused.
class DiagnosticsOutput : public MessageOutput<diagnostic_msgs::DiagnosticArray>
{
public:
  struct Driver
  {
    std::string car;
    const CommandInput & commands;
  };

  /// @param factor  that is asked for; only for paced time
  DiagnosticsOutput(ros::NodeHandle & node, TimeMode mode, double factor, std::vector<Driver> drivers);
  void update(SimTime now, bool anyway) override;

private:
  void fill(diagnostic_msgs::DiagnosticArray & message, SimTime now) override;
  diagnostic_msgs::DiagnosticStatus timeStatus() const;
  static diagnostic_msgs::DiagnosticStatus commandStatus(const Driver & driver);

  const TimeMode mode_;
  const double wanted_factor_;
  const std::vector<Driver> drivers_;
  double factor_{0.0};
  SimTime last_time_{0};
  ros::WallTime last_wall_{ros::WallTime::now()};
};
}  // namespace f1tenth_sim2d
