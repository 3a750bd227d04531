#include <gtest/gtest.h>

#include <deque>

#include "journey.h"

// Plans that are made while the car is controlled.
namespace f1tenth_racer
{
namespace
{
using testing::drawOval;
using testing::Journey;
using testing::JourneyOptions;
using testing::makeCostmap;
using testing::onOval;
using testing::racingJourney;

// Works only when it is told to.
class SlowWorker
{
public:
  PlanWorker worker()
  {
    return [this](std::function<PlanAnswer()> job) {
      jobs_.emplace_back(std::move(job));
      return jobs_.back().get_future();
    };
  }

  std::size_t pending() const { return jobs_.size(); }

  void work()
  {
    for (; !jobs_.empty(); jobs_.pop_front()) {
      jobs_.front()();
    }
  }

private:
  std::deque<std::packaged_task<PlanAnswer()>> jobs_;
};

class PlanningBeside : public ::testing::Test
{
protected:
  PlanningBeside() : journey_(racingJourney(), makeCostmap(drawOval()), onOval(0.0), slow_.worker()) {}

  void driveOff()
  {
    journey_.navigator.setGoal(onOval(14.0), journey_.time);
    journey_.cycle();
    slow_.work();
    while (journey_.car.state().speed < 2.5) {
      ASSERT_TRUE(journey_.cycle().command);
    }
  }

  // Works for every plan before the next cycle.
  Outcome untilOutcome()
  {
    for (const double end = journey_.time + 60.0; journey_.time < end;) {
      slow_.work();
      if (const auto outcome = journey_.cycle().outcome) {
        return *outcome;
      }
    }
    return {false, "nothing within the limit"};
  }

  void expectAtGoal(const Pose2 & goal)
  {
    EXPECT_TRUE(untilOutcome().succeeded);
    EXPECT_LT(distance(journey_.car.state().pose, goal), 0.2);
    EXPECT_GT(journey_.clearance, 0.3);
  }

  SlowWorker slow_;
  Journey journey_;
};

TEST_F(PlanningBeside, aGoalWhereTheCarStandsWithoutAPathIsReachedAndItStays)
{
  JourneyOptions options = racingJourney();
  options.free_goal_vel = true;
  Journey journey(options, makeCostmap(drawOval()), onOval(0.0), slow_.worker());
  journey.cycle();
  journey.navigator.setGoal(onOval(0.1), journey.time, {onOval(6.0)});
  EXPECT_TRUE(journey.cycle().outcome.value_or(Outcome{}).succeeded);
  EXPECT_FALSE(journey.navigator.drives());
  for (int i = 0; i < 10; ++i) {
    const auto command = journey.cycle().command;
    ASSERT_TRUE(command) << i;
    EXPECT_EQ(command->speed, 0.0);
  }
}

TEST_F(PlanningBeside, aCarThatStandsWaitsForItsPlan)
{
  journey_.navigator.setGoal(onOval(20.0), journey_.time);
  for (int i = 0; i < 100; ++i) {
    const CycleOutput output = journey_.cycle();
    ASSERT_TRUE(output.command) << i;
    EXPECT_EQ(output.command->speed, 0.0);
    EXPECT_FALSE(output.new_plan);
  }
  EXPECT_EQ(slow_.pending(), 1U);
  slow_.work();
  EXPECT_TRUE(journey_.cycle().new_plan);
  expectAtGoal(onOval(20.0));
}

TEST_F(PlanningBeside, aPlanThatIsMadeSoonSlowsTheCarByNothing)
{
  driveOff();
  const double speed = journey_.car.state().speed;
  journey_.navigator.setGoal(onOval(18.0), journey_.time);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(journey_.cycle().new_plan);
    EXPECT_GE(journey_.car.state().speed, speed - 0.05) << i;
  }
  slow_.work();
  EXPECT_TRUE(journey_.cycle().new_plan);
  EXPECT_GE(journey_.car.state().speed, speed - 0.05);
  expectAtGoal(onOval(18.0));
}

TEST_F(PlanningBeside, whileAPlanTakesLongTheCarStopsOnItsOldWay)
{
  driveOff();
  journey_.navigator.setGoal(onOval(18.0), journey_.time);
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(journey_.cycle().command) << i;
  }
  EXPECT_LT(std::abs(journey_.car.state().speed), 0.05);
  EXPECT_EQ(slow_.pending(), 1U);
  expectAtGoal(onOval(18.0));
}

TEST_F(PlanningBeside, aPlanThatComesTooLateToBeDrivenIsMadeAnew)
{
  driveOff();
  journey_.navigator.setGoal(onOval(18.0), journey_.time);
  journey_.cycle();
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(journey_.cycle().command) << i;
  }
  journey_.car = testing::KinematicCar(onOval(10.0));
  expectAtGoal(onOval(18.0));
}

// It brakes meanwhile, and may soon be slow enough.
TEST_F(PlanningBeside, whereAPlanCannotBeDrivenAnotherIsAskedForSoon)
{
  driveOff();
  journey_.navigator.setGoal(onOval(18.0), journey_.time);
  journey_.cycle();
  const Pose2 beside = compose(journey_.car.state().pose, {0.0, 0.8, 0.0});
  journey_.car = testing::KinematicCar(beside);
  journey_.car.drive({2.0, 0.0}, 0.5);
  slow_.work();
  EXPECT_FALSE(journey_.cycle().new_plan);
  EXPECT_EQ(slow_.pending(), 0U);
  const double before = journey_.command.speed;
  journey_.cycle();
  journey_.cycle();
  EXPECT_LT(journey_.command.speed, before);
  EXPECT_EQ(slow_.pending(), 1U);
}

TEST_F(PlanningBeside, cancellingStopsTheCarAtOnceAndTheOldPlanIsNotTaken)
{
  driveOff();
  journey_.navigator.setGoal(onOval(18.0), journey_.time);
  journey_.cycle();
  journey_.navigator.cancel();
  EXPECT_EQ(journey_.cycle().command->speed, 0.0);
  slow_.work();
  const CycleOutput output = journey_.cycle();
  EXPECT_FALSE(output.new_plan);
  EXPECT_FALSE(output.outcome);
  EXPECT_EQ(output.command->speed, 0.0);
}

TEST_F(PlanningBeside, aNewGoalMakesThePlanForTheOldOneUnwanted)
{
  journey_.navigator.setGoal(onOval(10.0), journey_.time);
  journey_.cycle();
  journey_.navigator.setGoal(onOval(20.0), journey_.time);
  journey_.cycle();
  slow_.work();
  EXPECT_FALSE(journey_.cycle().new_plan);
  expectAtGoal(onOval(20.0));
}

TEST_F(PlanningBeside, aGoalWithoutAWayIsAbortedWhenThatIsKnown)
{
  journey_.navigator.setGoal({9.0, 5.0, 0.0}, journey_.time);
  EXPECT_FALSE(journey_.cycle().outcome);
  slow_.work();
  const CycleOutput output = journey_.cycle();
  ASSERT_TRUE(output.outcome);
  EXPECT_EQ(output.outcome->text, "Failed to find a valid plan. The goal is in a wall.");
}

TEST(PlanningOnAThread, reachesGoals)
{
  const PlanWorker thread = [](std::function<PlanAnswer()> job) {
    return std::async(std::launch::async, std::move(job));
  };
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0), thread);
  for (const double goal : {10.0, 20.0}) {
    journey.navigator.setGoal(onOval(1.0), journey.time);
    journey.cycle();
    journey.navigator.setGoal(onOval(goal), journey.time);
    EXPECT_TRUE(journey.untilOutcome(1e6).succeeded);
    EXPECT_LT(distance(journey.car.state().pose, onOval(goal)), 0.2);
  }
}

TEST(RaceLinePlanner, givesUpAPlanThatIsNotWantedAnyMore)
{
  PlanRequest request{onOval(0.0), onOval(20.0)};
  request.dropped = std::make_shared<const std::atomic<bool>>(true);
  const Plan plan = RaceLinePlanner(PlannerOptions()).makePlan(makeCostmap(drawOval()), request);
  EXPECT_FALSE(plan.found());
  EXPECT_LE(plan.expansions, 10);
}
}  // namespace
}  // namespace f1tenth_racer
