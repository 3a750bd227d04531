#include "node/transport/owned_socket.h"

#include <gtest/gtest.h>

#include <future>
#include <string>

#include "tcp_pair.h"

namespace f1tenth_sim2d::test
{
namespace
{
bool send(const OwnedSocket & socket, const std::string & text)
{
  return socket.send(reinterpret_cast<const std::uint8_t *>(text.data()), text.size());
}
}  // namespace

TEST(OwnedSocket, KnowsItsPeer)
{
  const TcpPair pair;
  EXPECT_EQ(OwnedSocket(pair.ours()).peer(), pair.peer());
}

TEST(OwnedSocket, OfNoSocketHasNoPeerAndSendsNothing)
{
  const OwnedSocket socket(-1);
  EXPECT_EQ(socket.peer(), "");
  EXPECT_FALSE(send(socket, "x"));
}

TEST(OwnedSocket, OutlivesTheOneThatItWasMadeFrom)
{
  TcpPair pair;
  const OwnedSocket socket(pair.ours());
  EXPECT_NE(socket.get(), pair.ours());
  pair.closeOurs();
  EXPECT_TRUE(send(socket, "still here"));
  EXPECT_EQ(pair.read(10), "still here");
}

TEST(OwnedSocket, SendsAllOfWhatFitsOnlyPieceByPiece)
{
  const TcpPair pair;
  const OwnedSocket socket(pair.ours());
  const std::string much(50'000'000, 'a');
  auto read = std::async(std::launch::async, [&] { return pair.read(much.size()); });
  EXPECT_TRUE(send(socket, much));
  EXPECT_EQ(read.get(), much);
}

TEST(OwnedSocket, EndsTheConnectionIfTheOtherEndTakesNothing)
{
  const TcpPair pair;
  const OwnedSocket socket(pair.ours());
  EXPECT_FALSE(send(socket, std::string(50'000'000, 'a')));
  EXPECT_FALSE(send(socket, "b"));
}

TEST(OwnedSocket, SendsNothingToAnEndThatHasHungUp)
{
  TcpPair pair;
  const OwnedSocket socket(pair.ours());
  pair.hangUp();
  send(socket, "the first is answered by a reset");
  EXPECT_FALSE(send(socket, "x"));
}
}  // namespace f1tenth_sim2d::test
