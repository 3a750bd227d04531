#pragma once

#include <ros/time.h>

#include <optional>
#include <string>
#include <vector>

namespace sim2d_lockstep
{
/// Up to which simulated time each of some participants has acted. Stamps as in /sim2d/done.
class DoneLedger
{
public:
  explicit DoneLedger(const std::vector<std::string> & names);

  /// Names that are not in the ledger are ignored. The latest word counts, even if it is an earlier time. Of who has not been
  /// heard since startAgain(), a later time counts when it is said a second time: the first one may have been under way.
  void note(const std::string & name, const ros::Time & stamp);
  bool allDone(const ros::Time & stamp) const;
  /// Names that have not acted up to stamp, in the order given.
  std::vector<std::string> missing(const ros::Time & stamp) const;
  /// Time has jumped back to stamp, the end of the first period: forgets what was said for later times, but not who has left.
  void startAgain(const ros::Time & stamp);

private:
  struct Entry
  {
    std::string name;
    std::optional<ros::Time> done;
    std::optional<ros::Time> doubtful;  // may belong to the run before
    bool is_heard{true};                // since startAgain()
  };

  bool believes(const Entry & entry, const ros::Time & stamp) const;

  // A handful of names: searching in order is quicker than a map and keeps the order.
  std::vector<Entry> entries_;
  ros::Time start_;
};
}  // namespace sim2d_lockstep
