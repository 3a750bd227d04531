#pragma once

#include <ros/time.h>

#include <optional>
#include <string>
#include <vector>

namespace sim2d_lockstep
{
/// Added to the name of a Python node's roscpp half: the master would end one of two nodes with the same name.
constexpr char kSecondHalf[] = "_roscpp";

/// Whether a node, by its name with the leading slash, is this participant: nobody answers for another.
bool isParticipant(const std::string & caller, const std::string & participant);

/// The simulated time up to which each participant has acted. Stamps as in /sim2d/done.
class DoneLedger
{
public:
  explicit DoneLedger(const std::vector<std::string> & names);

  /// Names that are not in the ledger are ignored. The latest message counts, even if its time is earlier. From a
  /// participant not heard since startAgain(), a later time counts once it is repeated: the first one may have been
  /// under way before.
  void note(const std::string & name, const ros::Time & stamp);
  bool allDone(const ros::Time & stamp) const;
  /// Participants that have not acted up to stamp, in the order given.
  std::vector<std::string> missing(const ros::Time & stamp) const;
  /// Time has jumped back to stamp, the end of the first period: forgets answers for later times, but not who has left.
  void startAgain(const ros::Time & stamp);

private:
  struct Entry
  {
    std::string name;
    std::optional<ros::Time> done;
    std::optional<ros::Time> doubtful;  // may belong to the previous run
    bool is_heard{true};                // since startAgain()
  };

  bool believes(const Entry & entry, const ros::Time & stamp) const;

  // A handful of names: a linear search is faster than a map and keeps the order.
  std::vector<Entry> entries_;
  ros::Time start_;
};
}  // namespace sim2d_lockstep
