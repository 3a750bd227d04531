#include "node/transport/subscriber_connections.h"

#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <regex>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
// Columns of what roscpp says about a connection of a topic.
constexpr int kNodeColumn = 1;
constexpr int kTransportColumn = 6;
}  // namespace

std::optional<SubscriberConnection> connectionIn(const std::string & transport_info)
{
  static const std::regex kTcp(R"(TCPROS connection on port \d+ to \[(\S+) on socket (\d+)\])");
  std::smatch match;
  if (!std::regex_match(transport_info, match, kTcp)) {
    return std::nullopt;
  }
  return SubscriberConnection{"", std::stoi(match[2]), match[1]};
}

std::vector<SubscriberConnection> connectionsOf(ros::Publication & publication)
{
  XmlRpc::XmlRpcValue info;
  info.setSize(0);
  publication.getInfo(info);
  std::vector<SubscriberConnection> connections;
  for (int i = 0; i < info.size(); ++i) {
    if (auto connection = connectionIn(info[i][kTransportColumn])) {
      connection->node = static_cast<std::string>(info[i][kNodeColumn]);
      connections.push_back(*std::move(connection));
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
