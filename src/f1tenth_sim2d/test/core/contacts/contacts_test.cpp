#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
const Contact * find(const std::vector<Contact> & contacts, const std::string & own)
{
  const auto found = std::find_if(
    contacts.begin(), contacts.end(), [&](const Contact & contact) { return contact.own_collision == own; });
  return found != contacts.end() ? &*found : nullptr;
}

TEST(Contacts, WallAheadIsReportedByTheFrontBumperAlone)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 2.0);
  const std::vector<Contact> & contacts = simulation.contacts(kRobot1);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].own_collision, "car::bumper_front::collision");
  EXPECT_EQ(contacts[0].other_collision, "walls::Wall_0::Wall_0_Collision");
  EXPECT_EQ(contacts[0].other_model, "walls");
  ASSERT_FALSE(contacts[0].positions.empty());
  EXPECT_NEAR(contacts[0].positions[0].x, 2.0, 0.005);
  EXPECT_NEAR(contacts[0].normals[0].x, -1.0, 1e-6);
  EXPECT_GE(contacts[0].depths[0], 0.0);
  EXPECT_LT(contacts[0].depths[0], 0.005);
  EXPECT_LT(contacts[0].force.x, -3.74 * 1.0 / 0.001);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 0.0, 0.02);
  EXPECT_EQ(simulation.clearance(kRobot1, 5.0), 0.0);
}

class PostAhead : public ::testing::TestWithParam<double>
{
};

TEST_P(PostAhead, TurnsTheCarToItsSide)
{
  Simulation simulation(world({staticModel("post", box("post::l::c", 0.02, 0.02, 1, 2, GetParam(), 0.5))}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 2.0);
  const Contact * contact = find(simulation.contacts(kRobot1), "car::bumper_front::collision");
  ASSERT_NE(contact, nullptr);
  EXPECT_LT(contact->force.x, 0.0);
  EXPECT_GT(contact->torque * GetParam(), 0.0);
  EXPECT_GT(simulation.state(kRobot1).pose.yaw * GetParam(), 0.0);
}
INSTANTIATE_TEST_SUITE_P(Sides, PostAhead, ::testing::Values(-0.08, 0.08));

class FastCrash : public ::testing::TestWithParam<double>
{
};

TEST_P(FastCrash, NeverPassesThroughTheWall)
{
  Simulation simulation(world({wallAcross(12.0)}));
  simulation.addCar(car("robot1"), {}, {0, 0, GetParam()});
  double farthest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    simulation.command(kRobot1, {GetParam() == 0.0 ? 20.0 : 15.0, 0.0});
    simulation.step();
    farthest = std::max(farthest, simulation.state(kRobot1).pose.x);
  }
  EXPECT_LT(farthest, 12.0 - 0.1);
  EXPECT_GT(farthest, 11.0);
}
INSTANTIATE_TEST_SUITE_P(Angles, FastCrash, ::testing::Values(0.0, 0.2, -0.5, 0.9));

TEST(Contacts, ThinSheetStopsTheFastestCar)
{
  Simulation simulation(world({staticModel("sheet", box("sheet::l::c", 0.004, 5, 1, 12, 0, 0.5))}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {20.0, 0.0}, 3.0);
  EXPECT_LT(simulation.state(kRobot1).pose.x, 12.0 - 0.39);
}

TEST(Contacts, CoarsePhysicsStepDoesNotLetACarThrough)
{
  Simulation simulation(world({wallAcross(12.0)}), {0.02, 0});
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {20.0, 0.0}, 3.0);
  EXPECT_LT(simulation.state(kRobot1).pose.x, 12.0 - 0.39);
  EXPECT_GT(simulation.state(kRobot1).pose.x, 11.0);
}

TEST(Contacts, CarThatSlidesAlongAWallReportsEveryPeriod)
{
  Solid slippery = box("walls::Wall_0::c", 40, 0.15, 2.5, 20, 0.7, 1.25);
  slippery.mu = 0.1;
  Simulation simulation(world({staticModel("walls", slippery)}));
  simulation.addCar(car("robot1"), {}, {0, 0.4, 0.05});
  drive(simulation, kRobot1, {2.0, 0.03}, 3.0);
  const double start = simulation.state(kRobot1).pose.x;
  Vec2 force;
  for (int period = 0; period < 80; ++period) {
    simulation.clearContacts(kRobot1);
    drive(simulation, kRobot1, {2.0, 0.03}, 0.025);
    const Contact * contact = find(simulation.contacts(kRobot1), "car::bumper_left::collision");
    ASSERT_NE(contact, nullptr) << "period " << period;
    EXPECT_LE(contact->force.y, 0.0);
    EXPECT_NEAR(contact->positions[0].y, 0.625, 0.002);
    force = {force.x + contact->force.x, force.y + contact->force.y};
  }
  EXPECT_LT(force.y, 0.0);
  EXPECT_NEAR(force.x, slippery.mu * force.y, 0.01 * std::abs(force.y));
  EXPECT_GT(simulation.state(kRobot1).pose.x, start + 2.0);
}

TEST(Contacts, AreKeptUntilTheyAreCleared)
{
  Simulation simulation(world({wallAcross(1.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 1.0);
  drive(simulation, kRobot1, {-2.0, 0.0}, 1.5);
  EXPECT_EQ(simulation.contacts(kRobot1).size(), 1u);
  simulation.clearContacts(kRobot1);
  EXPECT_TRUE(simulation.contacts(kRobot1).empty());
  drive(simulation, kRobot1, {-1.0, 0.0}, 0.1);
  EXPECT_TRUE(simulation.contacts(kRobot1).empty());
}

TEST(Contacts, ImpactShowsItsFullForceThoughLaterStepsPushLess)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 0.5);
  double speed = 0.0;
  while (simulation.contacts(kRobot1).empty()) {
    speed = simulation.state(kRobot1).velocity.x;
    drive(simulation, kRobot1, {2.0, 0.0}, 0.001);
  }
  drive(simulation, kRobot1, {2.0, 0.0}, 0.02);
  EXPECT_NEAR(simulation.contacts(kRobot1)[0].force.x, -3.74 * speed / 0.001, 0.05 * 3.74 * speed / 0.001);
}

TEST(Contacts, EachBumperReportsItsSide)
{
  const struct
  {
    const char * bumper;
    Pose2 start;
    double speed;
  } cases[] = {
    {"car::bumper_front::collision", {2, 0, 0}, 1.0},
    {"car::bumper_rear::collision", {-2, 0, 0}, -1.0},
  };
  for (const auto & c : cases) {
    Simulation simulation(world({room(3.0)}));
    simulation.addCar(car("robot1"), {}, c.start);
    drive(simulation, kRobot1, {c.speed, 0.0}, 2.0);
    ASSERT_EQ(simulation.contacts(kRobot1).size(), 1u) << c.bumper;
    EXPECT_EQ(simulation.contacts(kRobot1)[0].own_collision, c.bumper);
  }
}

TEST(Contacts, CarFitsUnderATableAndHitsItsLegs)
{
  ModelDescription table = staticModel("table", box("table::top::collision", 1, 1, 0.04, 2, 0, 0.72));
  table.solids.push_back(box("table::leg::collision", 0.04, 0.04, 0.7, 2.4, 0.1, 0.35));
  Simulation simulation(world({table}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {1.0, 0.0}, 4.0);
  ASSERT_EQ(simulation.contacts(kRobot1).size(), 1u);
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_collision, "table::leg::collision");
  EXPECT_NEAR(simulation.state(kRobot1).pose.x + 0.4, 2.38, 0.01);
}

TEST(Contacts, OfABallACarTouchesWhatReachesDownToIt)
{
  Solid ball{"ball::link::collision", Sphere{1.0}, Pose3(3, 0, 1, 0, 0, 0)};
  Simulation simulation(world({staticModel("ball", ball)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {1.0, 0.0}, 4.0);
  // The front bumper reaches up to 0.095 m, where the ball has a radius of 0.4257 m; the chassis, 5 mm behind it,
  // up to 0.12 m, where it has 0.4750 m.
  EXPECT_NEAR(simulation.state(kRobot1).pose.x + 0.395, 3.0 - 0.475, 0.005);
  EXPECT_EQ(simulation.contacts(kRobot1)[0].own_collision, "car::chassis::collision");
}

TEST(Contacts, FloorBoxDoesNotCount)
{
  Simulation simulation(world({staticModel("floor", box("floor::l::c", 20, 20, 0.1, 0, 0, -0.05))}));
  CarDescription description = car("robot1");
  description.solids.push_back(box("car::wheel::collision", 0.1, 0.05, 0.1, 0, 0.08, 0.05));
  simulation.addCar(description, {}, {});
  drive(simulation, kRobot1, {1.0, 0.0}, 0.5);
  EXPECT_TRUE(simulation.contacts(kRobot1).empty());
}

TEST(Contacts, CarsCollideAndBothReport)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {1.5, 0.0, 0.0});
  for (int i = 0; i < 1500; ++i) {
    simulation.command(kRobot1, {2.0, 0.0});
    simulation.step();
  }
  ASSERT_FALSE(simulation.contacts(kRobot1).empty());
  ASSERT_FALSE(simulation.contacts(kRobot2).empty());
  EXPECT_EQ(simulation.contacts(kRobot1)[0].own_collision, "car::bumper_front::collision");
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_model, "robot2");
  EXPECT_EQ(simulation.contacts(kRobot2)[0].own_collision, "car::bumper_rear::collision");
  EXPECT_EQ(simulation.contacts(kRobot2)[0].other_model, "robot1");
  EXPECT_DOUBLE_EQ(simulation.contacts(kRobot1)[0].force.x, -simulation.contacts(kRobot2)[0].force.x);
  EXPECT_DOUBLE_EQ(simulation.contacts(kRobot1)[0].normals[0].x, -simulation.contacts(kRobot2)[0].normals[0].x);
  EXPECT_GT(simulation.state(kRobot2).pose.x, 1.5) << "it was pushed";
}

double energy(const Simulation & simulation, CarId car)
{
  const CarState & state = simulation.state(car);
  const VehicleParameters & p = simulation.parameters(car);
  const double lateral = state.velocity.y + p.l_r * state.yaw_rate;
  return 0.5 * p.m * (state.velocity.x * state.velocity.x + lateral * lateral) +
         0.5 * p.I_z * state.yaw_rate * state.yaw_rate;
}

class CarsMeet : public ::testing::TestWithParam<Pose2>
{
};

TEST_P(CarsMeet, NoEnergyIsGained)
{
  Simulation simulation(world());
  VehicleParameters parameters;
  parameters.actuation_latency = 0.0;  // so that the motors stop at the impact
  simulation.addCar(car("robot1"), parameters, {});
  simulation.addCar(car("robot2"), parameters, GetParam());
  while (simulation.contacts(kRobot1).empty() && simulation.time() < 3'000'000'000) {
    simulation.command(kRobot1, {3.0, 0.0});
    simulation.step();
  }
  ASSERT_FALSE(simulation.contacts(kRobot1).empty());
  const double at_impact = 0.5 * 3.74 * 9.0;
  double last = at_impact;
  for (int i = 0; i < 1000; ++i) {
    const double now = energy(simulation, kRobot1) + energy(simulation, kRobot2);
    ASSERT_LE(now, last + 1e-6) << "step " << i;
    last = now;
    simulation.command(kRobot1, {0.0, 0.0});
    simulation.step();
    if (simulation.time() % 25'000'000 == 0) {
      simulation.clearContacts(kRobot1);
    }
  }
  EXPECT_LT(last, 0.5 * at_impact);
}
INSTANTIATE_TEST_SUITE_P(
  Places, CarsMeet,
  ::testing::Values(
    Pose2{2, 0, 0}, Pose2{2, 0.1, 1.2}, Pose2{2, -0.15, -0.4}, Pose2{2.2, 0.2, 2.9}, Pose2{2, 0, 1.57}));

TEST(Contacts, ModelsThatFollowOneThatWasTakenOutAreNotTakenForIt)
{
  Simulation simulation(world({movableBox("first", 0.2, 1.0, 0.0), movableBox("second", 0.2, 1.0, 5.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 0.8);
  ASSERT_EQ(simulation.contacts(kRobot1).size(), 1u);
  simulation.removeModel(0);
  simulation.placeCar(kRobot1, {0.0, 5.0, 0.0});
  drive(simulation, kRobot1, {2.0, 0.0}, 0.8);
  ASSERT_EQ(simulation.contacts(kRobot1).size(), 2u);
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_model, "first");
  EXPECT_EQ(simulation.contacts(kRobot1)[1].other_model, "second");
}

TEST(Contacts, PairThatTouchesAgainHasOneEntryAlsoAfterAModelWasTakenOut)
{
  Simulation simulation(world({movableBox("far", 0.2, 1.0, 5.0), movableBox("near", 0.2, 1.0, 0.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 0.8);
  simulation.removeModel(0);
  simulation.placeCar(kRobot1, {-1.0, 0.0, 0.0});
  drive(simulation, kRobot1, {2.0, 0.0}, 2.0);
  ASSERT_EQ(simulation.contacts(kRobot1).size(), 1u);
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_model, "near");
}
}  // namespace f1tenth_sim2d::test
