#include "node/world/schedule.h"

#include <gtest/gtest.h>

#include <vector>

using f1tenth_sim2d::periodOf;
using f1tenth_sim2d::Schedule;
using f1tenth_sim2d::SimTime;

namespace
{
std::vector<SimTime> timesUntil(Schedule & schedule, std::vector<SimTime> & seen, SimTime end)
{
  while (schedule.nextDue() <= end) {
    schedule.run(schedule.nextDue());
  }
  return seen;
}
}  // namespace

TEST(Schedule, TimesAreExactMultiples)
{
  Schedule schedule;
  std::vector<SimTime> seen;
  schedule.add(periodOf(40.0), [&](SimTime now) { seen.push_back(now); });
  timesUntil(schedule, seen, 100000000);
  EXPECT_EQ(seen, (std::vector<SimTime>{25000000, 50000000, 75000000, 100000000}));
}

TEST(Schedule, PeriodWithAFractionDoesNotDrift)
{
  Schedule schedule;
  std::vector<SimTime> seen;
  schedule.add(periodOf(30.0), [&](SimTime now) { seen.push_back(now); });
  timesUntil(schedule, seen, 3600 * 1000000000LL);
  ASSERT_EQ(seen.size(), 3600u * 30u);
  EXPECT_EQ(seen.front(), 33333333);
  EXPECT_EQ(seen.back(), 3600 * 1000000000LL);
}

TEST(Schedule, SameTimeRunsInTheOrderOfAdding)
{
  Schedule schedule;
  std::vector<SimTime> order;
  schedule.add(2.0, [&](SimTime) { order.push_back(1); });
  schedule.add(1.0, [&](SimTime) { order.push_back(2); });
  timesUntil(schedule, order, 2);
  EXPECT_EQ(order, (std::vector<SimTime>{2, 1, 2}));
}

TEST(Schedule, RateThatCannotBeKeptRunsOnceForAllThatHasPassed)
{
  Schedule schedule;
  int runs = 0;
  schedule.add(1.0, [&](SimTime) { ++runs; });
  schedule.run(10);
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(schedule.nextDue(), 11);
}

TEST(Schedule, AnyRateIsAnswered)
{
  constexpr SimTime kHour = 3600 * 1000000000LL;
  Schedule schedule;
  std::vector<double> runs;
  for (const double rate_hz : {1e-12, 1e15, 1e300}) {
    schedule.add(
      periodOf(rate_hz), [&runs, rate_hz](SimTime) { runs.push_back(rate_hz); }, kHour);
  }
  EXPECT_EQ(schedule.nextDue(), kHour + 1);
  schedule.run(2 * kHour);
  EXPECT_EQ(runs, (std::vector<double>{1e15, 1e300}));
  EXPECT_EQ(schedule.nextDue(), 2 * kHour + 1);
}

TEST(Schedule, RestartGoesBackToTheBeginning)
{
  Schedule schedule;
  schedule.add(5.0, [](SimTime) {});
  schedule.run(5);
  schedule.restart();
  EXPECT_EQ(schedule.nextDue(), 5);
}
