#pragma once

#include <ros/duration.h>
#include <ros/time.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The node's side of lockstep: act once per control period, on inputs that do not depend on how fast the machine is.
/// The protocol is docs/lockstep.md.
namespace sim2d_lockstep
{
/// Stamp of a participant that has left for good.
inline const ros::Time kLeft{2147483647, 0};

/// Lets roscpp's poll thread go round twice, so that what was in this process's sockets is in its callback queues and
/// what it had published is in the sockets. roscpp promises neither: the poll thread reads and writes its sockets in
/// no particular order, whatever the order of sending or publishing.
///  - Before acting on a message: whatever was sent before it, over any connection, has arrived.
///  - Before publishing a message that announces others (/clock, done): the others are on their way before it.
/// A message larger than the sockets' buffers (some MB) may take longer; such messages do not belong in a period.
/// Connections that are made while there is one, from a publisher of this process, hold no small message back, whether the
/// subscriber asks for tcpNoDelay or not.
class InboxDrain
{
public:
  /// Needs a started ROS (a ros::NodeHandle exists).
  InboxDrain();
  ~InboxDrain();
  InboxDrain(const InboxDrain &) = delete;
  InboxDrain & operator=(const InboxDrain &) = delete;

  /// Blocks for some 10 us of wall time; returns at once when ROS shuts down. Thread-safe, but not to be called from
  /// roscpp's poll thread.
  void drain();

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// A node that is named in the simulator's `participants`.
/// Listens to /clock and /sim2d/done on a callback queue of its own that is served inside waitForPeriod(), so it needs
/// no spinner and does not touch the node's own queues. Use an object from one thread at a time.
/// Subscribe to what must arrive within a period from who does not take part with ros::TransportHints().tcpNoDelay(), or
/// the kernel may delay it.
class Participant
{
public:
  /// @param name   as in `participants`: the node's name without the leading slash ("robot1/move_base")
  /// @param after  participants that act before this one in every period; their messages of a period have arrived
  ///               when this one acts on it. Empty: acts as soon as the period's /clock is there.
  /// @throws std::invalid_argument for an empty name, one with a leading slash, or one that would act after itself
  explicit Participant(std::string name, const std::vector<std::string> & after = {});
  ~Participant();
  Participant(const Participant &) = delete;
  Participant & operator=(const Participant &) = delete;

  /// Blocks until the next period that has not been answered. On return everything published in that period by the
  /// simulator and by `after`, and in earlier periods by anyone, is in the callback queues of this process, and
  /// ros::Time::now() is the period's stamp if ROS runs on simulated time.
  /// A period that was answered already and whose /clock comes again (the simulator repeats the first one until
  /// everybody is there) is answered again in here. A clock that jumps back starts a new run.
  /// @return the period's stamp; nothing when timeout (wall time) has passed or ROS shuts down
  std::optional<ros::Time> waitForPeriod(ros::WallDuration timeout);

  /// Publishes on /sim2d/done that this node has acted up to stamp, after everything it has published before.
  /// Send the first one only when the node is ready to act (map received, servers connected): the simulator waits.
  /// @param until  for a node that acts less often than every period: until the first period that ends then or later,
  ///               nobody waits for it and waitForPeriod() returns no period; ros::Time(), the default: acts in the
  ///               next one
  void done(const ros::Time & stamp, const ros::Time & until = {});

  /// Acts in every period and calls done(), until ROS shuts down or the participant has left.
  /// @param act  called with a period's stamp; returns whether the node was ready to act, otherwise is called again
  ///             for the same period; may call leave()
  void actInPeriods(const std::function<bool(const ros::Time &)> & act);

  /// Leaves for good: the simulator and all that act after this participant never wait for it again. Blocks until the
  /// simulator has gone on without it, at most 1 s of wall time: if the process ends earlier, its last message may be
  /// lost. waitForPeriod() returns nothing from then on.
  void leave();

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace sim2d_lockstep
