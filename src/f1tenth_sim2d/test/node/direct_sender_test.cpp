#include "node/transport/direct_sender.h"

#include <gtest/gtest.h>
#include <ros/subscriber_link.h>

#include <memory>
#include <string>

#include "tcp_pair.h"

namespace f1tenth_sim2d::test
{
namespace
{
/// A subscriber as roscpp describes it.
class Link : public ros::SubscriberLink
{
public:
  explicit Link(std::string transport) : transport_(std::move(transport)) {}
  void enqueueMessage(const ros::SerializedMessage & /*message*/, bool /*serialize*/, bool /*no_copy*/) override {}
  void drop() override {}
  std::string getTransportType() override { return "TCPROS"; }
  std::string getTransportInfo() override { return transport_; }

private:
  const std::string transport_;
};

class DirectSenderTest : public testing::Test
{
protected:
  ros::SubscriberLinkPtr join(const std::string & transport)
  {
    ros::SubscriberLinkPtr link(new Link(transport));
    publication_.addSubscriberLink(link);
    return link;
  }
  ros::SubscriberLinkPtr join(const TcpPair & pair) { return join(pair, pair.peer()); }
  ros::SubscriberLinkPtr join(const TcpPair & pair, const std::string & peer)
  {
    return join("TCPROS connection on port 1 to [" + peer + " on socket " + std::to_string(pair.ours()) + "]");
  }
  bool send(const std::string & text)
  {
    return sender_.send(reinterpret_cast<const std::uint8_t *>(text.data()), text.size());
  }

  ros::Publication publication_{"/topic", "type", "md5", "", 1, false, false};
  DirectSender sender_;
};
}  // namespace

TEST_F(DirectSenderTest, SendsToAllSubscribers)
{
  const TcpPair one;
  const TcpPair other;
  join(one);
  join(other);
  sender_.lookAt(publication_);
  EXPECT_FALSE(sender_.isOutdated(publication_));
  EXPECT_TRUE(sender_.allReadStreams());
  EXPECT_TRUE(send("hello"));
  EXPECT_EQ(one.read(5), "hello");
  EXPECT_EQ(other.read(5), "hello");
}

TEST_F(DirectSenderTest, IsOutdatedUntilItHasLookedAndWhenSubscribersComeAndGo)
{
  EXPECT_TRUE(sender_.isOutdated(publication_));
  const TcpPair pair;
  const auto link = join(pair);
  sender_.lookAt(publication_);
  publication_.removeSubscriberLink(link);
  EXPECT_TRUE(sender_.isOutdated(publication_));
  sender_.lookAt(publication_);
  EXPECT_FALSE(sender_.isOutdated(publication_));
  join(pair);
  EXPECT_TRUE(sender_.isOutdated(publication_));
}

TEST_F(DirectSenderTest, SendsToNobodyIfOneSubscriberHasNoSocket)
{
  const TcpPair pair;
  join(pair);
  join("INTRAPROCESS");
  sender_.lookAt(publication_);
  EXPECT_FALSE(send("hello"));
  EXPECT_TRUE(pair.isEmpty());
  EXPECT_FALSE(sender_.isOutdated(publication_));
  EXPECT_FALSE(sender_.allReadStreams());
}

TEST_F(DirectSenderTest, SendsNothingToASocketThatIsSomebodyElsesByNow)
{
  const TcpPair pair;
  join(pair, "127.0.0.1:1");
  sender_.lookAt(publication_);
  EXPECT_FALSE(send("hello"));
  EXPECT_TRUE(pair.isEmpty());
}

TEST_F(DirectSenderTest, SendsToNobodyWhileOneSubscriberHasNoRoom)
{
  const TcpPair quick;
  const TcpPair slow;
  join(quick);
  join(slow);
  const std::string some(1000, 'a');
  while (::send(slow.ours(), some.data(), some.size(), MSG_DONTWAIT) > 0) {
  }
  sender_.lookAt(publication_);
  EXPECT_FALSE(send("hello"));
  EXPECT_TRUE(quick.isEmpty());
  EXPECT_FALSE(sender_.isOutdated(publication_));
}

TEST_F(DirectSenderTest, LeavesLargeBuffersToRoscpp)
{
  const TcpPair pair;
  join(pair);
  sender_.lookAt(publication_);
  EXPECT_FALSE(send(std::string(100'000, 'a')));
  EXPECT_TRUE(pair.isEmpty());
}

TEST_F(DirectSenderTest, NoticesThatAConnectionHasEnded)
{
  const TcpPair pair;
  join(pair);
  sender_.lookAt(publication_);
  shutdown(pair.ours(), SHUT_RDWR);
  EXPECT_FALSE(send("hello"));
  EXPECT_TRUE(sender_.isOutdated(publication_));
}
}  // namespace f1tenth_sim2d::test
