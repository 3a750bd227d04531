#pragma once

#include <ros/time.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sim2d_lockstep
{
/// Up to which simulated time each of some participants has acted.
class DoneLedger
{
public:
  explicit DoneLedger(const std::vector<std::string> & names);

  /// Names that are not in the ledger are ignored. The latest word counts, even if it is an earlier time.
  void note(const std::string & name, const ros::Time & stamp);
  bool allDone(const ros::Time & stamp) const;
  /// Time has jumped back to stamp: forgets what was said for later times, but not who has left.
  void startAgain(const ros::Time & stamp);

private:
  std::map<std::string, std::optional<ros::Time>> done_;
};
}  // namespace sim2d_lockstep
