#pragma once

#include <ros/publication.h>

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// A subscriber of one of our topics over TCP.
struct SubscriberConnection
{
  std::string node;  ///< its name
  int socket;        ///< ours
};

/// All of a topic; those within this process have no socket and are left out.
std::vector<SubscriberConnection> connectionsOf(ros::Publication & publication);

/// The socket in roscpp's description of a transport, "TCPROS connection on port 40000 to [::1:40001 on socket 12]"; -1
/// if there is none.
int socketIn(const std::string & transport_info);

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
