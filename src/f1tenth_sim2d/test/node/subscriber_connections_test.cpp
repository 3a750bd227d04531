#include "subscriber_connections.h"

#include <gtest/gtest.h>

using f1tenth_sim2d::socketIn;

TEST(SubscriberConnections, SocketOfATcpConnection)
{
  EXPECT_EQ(socketIn("TCPROS connection on port 41843 to [127.0.0.1:51234 on socket 17]"), 17);
}

TEST(SubscriberConnections, OtherTransportsHaveNone)
{
  EXPECT_EQ(socketIn("INTRAPROCESS"), -1);
  EXPECT_EQ(socketIn("UDPROS connection on port 41843 to [127.0.0.1:51234 on socket 17]"), -1);
  EXPECT_EQ(socketIn("TCPROS connection on port 41843 to [TCPServer Socket]"), -1);
}
