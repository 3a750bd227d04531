#include "node/transport/subscriber_connections.h"

#include <gtest/gtest.h>

using f1tenth_sim2d::connectionIn;

TEST(SubscriberConnections, SocketAndPeerOfATcpConnection)
{
  const auto connection = connectionIn("TCPROS connection on port 41843 to [127.0.0.1:51234 on socket 17]");
  ASSERT_TRUE(connection);
  EXPECT_EQ(connection->socket, 17);
  EXPECT_EQ(connection->peer, "127.0.0.1:51234");
}

TEST(SubscriberConnections, OtherTransportsHaveNone)
{
  EXPECT_FALSE(connectionIn("INTRAPROCESS"));
  EXPECT_FALSE(connectionIn("UDPROS connection on port 41843 to [127.0.0.1:51234 on socket 17]"));
  EXPECT_FALSE(connectionIn("TCPROS connection on port 41843 to [TCPServer Socket]"));
}
