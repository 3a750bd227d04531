#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "node/cars/fleet.h"
#include "node/messages/output.h"
#include "node/time/time_keeper.h"

namespace f1tenth_sim2d
{
/// `/diagnostics`, once per simulated second: how fast time really goes, and what drivers sent that was refused.
class DiagnosticsOutput : public MessageOutput<diagnostic_msgs::DiagnosticArray>
{
public:
  /// @param control  the requested flow of time
  DiagnosticsOutput(
    ros::Publisher publisher, const TimeControl & control, std::function<std::vector<Fleet::Driver>()> drivers);
  void update(SimTime now, bool anyway) override;

private:
  void fill(diagnostic_msgs::DiagnosticArray & message, SimTime now) override;
  diagnostic_msgs::DiagnosticStatus timeStatus() const;
  static diagnostic_msgs::DiagnosticStatus commandStatus(const Fleet::Driver & driver);

  const TimeControl & control_;
  const std::function<std::vector<Fleet::Driver>()> drivers_;
  TimeControl seen_;              // when last updated
  std::optional<double> factor_;  // none if time was disturbed since then
  SimTime last_time_{0};
  ros::WallTime last_wall_{ros::WallTime::now()};
};
}  // namespace f1tenth_sim2d
