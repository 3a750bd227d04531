#include "../../src/faulty_inputs/faulty_line.h"

#include <gtest/gtest.h>

namespace f1tenth_scenarios
{
using Numbers = std::vector<int>;

TEST(FaultyLine, PassesOnAtOnceWithoutAFault)
{
  FaultyLine<int> line({{1.0, 2.0, {}}});
  line.take(0.5, 1);
  line.take(0.5, 2);
  EXPECT_EQ(line.release(0.5), (Numbers{1, 2}));
  EXPECT_TRUE(line.release(0.6).empty());
}

TEST(FaultyLine, LosesWhatArrivesDuringAnOutage)
{
  FaultyLine<int> line({{1.0, 2.0, {}}});
  for (const double now : {0.975, 1.0, 1.975, 2.0}) {
    line.take(now, static_cast<int>(1000 * now));
  }
  EXPECT_EQ(line.release(2.0), (Numbers{975, 2000}));
}

TEST(FaultyLine, HoldsBackForTheDelay)
{
  FaultyLine<int> line({{1.0, 2.0, 0.2}});
  line.take(1.0, 1);
  line.take(1.1, 2);
  EXPECT_TRUE(line.release(1.175).empty());
  EXPECT_EQ(line.release(1.2), Numbers{1});
  EXPECT_EQ(line.release(1.3), Numbers{2});
}

TEST(FaultyLine, CatchesUpInOrderWhenTheDelayIsOver)
{
  FaultyLine<int> line({{1.0, 2.0, 0.2}});
  line.take(1.95, 1);
  EXPECT_TRUE(line.release(1.975).empty());
  line.take(2.0, 2);
  EXPECT_EQ(line.release(2.0), (Numbers{1, 2}));
}
}  // namespace f1tenth_scenarios
