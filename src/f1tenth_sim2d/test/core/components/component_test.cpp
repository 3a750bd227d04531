#include "f1tenth_sim2d/component.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "core/components/sonar/sonar.h"
#include "sample_world.h"

// What is put on a car sees its steps and contacts, and may command it.
namespace f1tenth_sim2d::test
{
namespace
{
/// Drives straight on and writes down what happens.
class Chauffeur : public CopiedComponent<Chauffeur>
{
public:
  bool acts() const override { return true; }
  void beforeStep(Simulation & simulation, CarId car) override
  {
    before_.push_back(simulation.time());
    simulation.command(car, {2.0, 0.0});
  }
  void afterStep(const Simulation & simulation, CarId /*car*/) override { after_.push_back(simulation.time()); }
  void onContact(const Contact & contact) override { touched_.insert(contact.other_model); }
  void restart() override { *this = {}; }

  std::vector<SimTime> before_;
  std::vector<SimTime> after_;
  std::set<std::string> touched_;
};

/// The same, without wanting to be called.
class Passenger : public Chauffeur
{
public:
  bool acts() const override { return false; }
};
}  // namespace

TEST(Component, IsCalledBeforeAndAfterEachStep)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  const auto chauffeur = std::make_shared<Chauffeur>();
  simulation.mount(kRobot1, chauffeur);
  simulation.step();
  simulation.step();
  EXPECT_EQ(chauffeur->before_, (std::vector<SimTime>{0, 1'000'000}));
  EXPECT_EQ(chauffeur->after_, (std::vector<SimTime>{1'000'000, 2'000'000}));
}

TEST(Component, DrivesTheCarAndFeelsWhatItTouches)
{
  Simulation simulation(world({wallAcross(1.0)}));
  simulation.addCar(car("robot1"), {}, {});
  const auto chauffeur = std::make_shared<Chauffeur>();
  simulation.mount(kRobot1, chauffeur);
  simulation.advanceTo(200'000'000);
  EXPECT_GT(simulation.state(kRobot1).pose.x, 0.0);
  EXPECT_TRUE(chauffeur->touched_.empty());
  simulation.advanceTo(2'000'000'000);
  EXPECT_EQ(chauffeur->touched_, std::set<std::string>{"walls"});
}

TEST(Component, CommandsAsADriverDoesWhoCommandsBetweenTheSteps)
{
  Simulation mounted(world());
  Simulation driven(world());
  for (Simulation * simulation : {&mounted, &driven}) {
    simulation->addCar(car("robot1"), {}, {});
  }
  mounted.mount(kRobot1, std::make_shared<Chauffeur>());
  mounted.advanceTo(500'000'000);
  drive(driven, kRobot1, {2.0, 0.0}, 0.5);
  EXPECT_EQ(mounted.state(kRobot1).pose.x, driven.state(kRobot1).pose.x);
}

TEST(Component, IsCalledOnlyIfItWantsToBe)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  const auto passenger = std::make_shared<Passenger>();
  simulation.mount(kRobot1, passenger);
  simulation.step();
  EXPECT_TRUE(passenger->before_.empty());
}

TEST(Component, IsTakenBackWithTheCars)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  const auto chauffeur = std::make_shared<Chauffeur>();
  simulation.mount(kRobot1, chauffeur);
  simulation.step();
  simulation.reset();
  EXPECT_TRUE(chauffeur->before_.empty());
}

TEST(Component, OfADescriptionIsClonedForEachCar)
{
  CarDescription description = car("robot1");
  const auto prototype = std::make_shared<Chauffeur>();
  description.components = {prototype};
  Simulation simulation(world());
  simulation.addCar(description, {}, {});
  description.name = "robot2";
  simulation.addCar(description, {}, {0.0, 2.0, 0.0});
  simulation.step();
  EXPECT_TRUE(prototype->before_.empty());
  EXPECT_NE(simulation.components(kRobot1).back(), simulation.components(kRobot2).back());
}

TEST(Component, LidarsComeFirstAndAreSampledAsScans)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  const Component & lidar = *simulation.components(kRobot1).front();
  ASSERT_EQ(lidar.channels().size(), 1u);
  ASSERT_EQ(sampleSize(lidar), 1081u);
  std::vector<double> numbers(1081);
  std::vector<float> ranges(1081);
  lidar.sample(simulation, kRobot1, numbers.data());
  simulation.scan(kRobot1, 0, ranges.data());
  EXPECT_EQ(std::vector<double>(ranges.begin(), ranges.end()), numbers);
}

TEST(Sonar, MeasuresTheNearestOfItsRays)
{
  CarDescription description = car("robot1");
  Sonar::Options options;
  options.rays = {{0.3, 0.0, 0.0}, 0.2, {-0.5, 0.0, 0.5}, 3.0};
  description.components = {std::make_shared<Sonar>(Mount{"sonar", "sonar", "sonar", Pose3(), 20.0}, options)};
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(description, {}, {});
  double range = 0.0;
  simulation.components(kRobot1).back()->sample(simulation, kRobot1, &range);
  EXPECT_NEAR(range, 1.7, 1e-9);
  simulation.placeCar(kRobot1, {0.0, 0.0, M_PI});
  simulation.components(kRobot1).back()->sample(simulation, kRobot1, &range);
  EXPECT_EQ(range, 3.0);
}
}  // namespace f1tenth_sim2d::test
