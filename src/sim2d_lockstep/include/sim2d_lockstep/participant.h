#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/time.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The node's side of lockstep: act once per control period, on inputs that do not depend on how fast the machine is.
/// The protocol is docs/lockstep.md.
namespace sim2d_lockstep
{
/// Moves everything that has already reached this process's sockets into its callback queues.
/// roscpp's poll thread reads the sockets in no particular order; after drain() whatever was sent before a message
/// that this process has seen is in its queue. Blocks for some 10 us of wall time. Thread-safe.
class InboxDrain
{
public:
  InboxDrain();
  ~InboxDrain();
  InboxDrain(const InboxDrain &) = delete;
  InboxDrain & operator=(const InboxDrain &) = delete;

  void drain();

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// A node that is named in the simulator's `participants`.
class Participant
{
public:
  /// @param name   as in `participants`: the node's name without the leading slash ("robot1/move_base")
  /// @param after  participants that act before this one in every period; their messages of a period have arrived
  ///               when this one acts on it. Empty: acts as soon as the period's /clock is there.
  explicit Participant(std::string name, std::vector<std::string> after = {});
  ~Participant();

  /// Blocks until the next period that has not been answered. On return everything published in that period by the
  /// simulator and by `after`, and in earlier periods by anyone, is in the callback queues of this process.
  /// Say the first done() only when the node is ready to act (map there, servers connected): the simulator waits.
  /// @return the period's stamp; nothing when timeout (wall time) has passed or ROS shuts down
  std::optional<ros::Time> waitForPeriod(ros::WallDuration timeout);

  /// Publishes on /sim2d/done that this node has acted up to stamp.
  void done(const ros::Time & stamp);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace sim2d_lockstep
