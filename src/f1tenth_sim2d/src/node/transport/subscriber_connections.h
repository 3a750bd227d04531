#pragma once

#include <ros/publication.h>

#include <optional>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// A subscriber of one of our topics over TCP.
struct SubscriberConnection
{
  std::string node;  ///< its name
  int socket;        ///< ours
  std::string peer;  ///< "127.0.0.1:51234"
};

/// All of a topic; those within this process have no socket and are left out.
std::vector<SubscriberConnection> connectionsOf(ros::Publication & publication);

/// The connection in roscpp's description of a transport, "TCPROS connection on port 40000 to [::1:40001 on socket 12]",
/// without the node's name; none if it is not over TCP.
std::optional<SubscriberConnection> connectionIn(const std::string & transport_info);

/// Bytes that wait in the kernel because the subscriber does not read them.
int unreadBytes(const SubscriberConnection & connection);
/// The subscribers that have the most left to read.
std::vector<SubscriberConnection> slowest(const std::vector<SubscriberConnection> & connections);
/// Sends what is there at once; otherwise the kernel holds small messages back until the subscriber has acknowledged
/// the one before, which takes up to 40 ms.
void disableDelay(const SubscriberConnection & connection);
/// Ends the connection; a subscriber that comes back to life connects anew.
void disconnect(const SubscriberConnection & connection);
}  // namespace f1tenth_sim2d
