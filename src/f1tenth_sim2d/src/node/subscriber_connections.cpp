#include "subscriber_connections.h"

#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstdlib>

namespace f1tenth_sim2d
{
namespace
{
// Columns of what roscpp says about a connection of a topic.
constexpr int kNodeColumn = 1;
constexpr int kTransportColumn = 6;
}  // namespace

int socketIn(const std::string & transport_info)
{
  static const std::string kWords = "on socket ";
  const std::size_t place = transport_info.rfind(kWords);
  if (transport_info.rfind("TCPROS", 0) != 0 || place == std::string::npos) {
    return -1;
  }
  return std::atoi(transport_info.c_str() + place + kWords.size());
}

std::vector<SubscriberConnection> connectionsOf(ros::Publication & publication)
{
  XmlRpc::XmlRpcValue info;
  info.setSize(0);
  publication.getInfo(info);
  std::vector<SubscriberConnection> connections;
  for (int i = 0; i < info.size(); ++i) {
    const int socket = socketIn(info[i][kTransportColumn]);
    if (socket >= 0) {
      connections.push_back({info[i][kNodeColumn], socket});
    }
  }
  return connections;
}

int unreadBytes(const SubscriberConnection & connection)
{
  int bytes = 0;
  return ioctl(connection.socket, SIOCOUTQ, &bytes) == 0 ? bytes : 0;
}

std::vector<SubscriberConnection> slowest(const std::vector<SubscriberConnection> & connections)
{
  int most = 1;
  for (const auto & connection : connections) {
    most = std::max(most, unreadBytes(connection));
  }
  std::vector<SubscriberConnection> result;
  std::copy_if(connections.begin(), connections.end(), std::back_inserter(result), [&](const auto & connection) {
    return unreadBytes(connection) >= most;
  });
  return result;
}

void disableDelay(const SubscriberConnection & connection)
{
  const int on = 1;
  setsockopt(connection.socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

void disconnect(const SubscriberConnection & connection)
{
  shutdown(connection.socket, SHUT_RDWR);
}
}  // namespace f1tenth_sim2d
