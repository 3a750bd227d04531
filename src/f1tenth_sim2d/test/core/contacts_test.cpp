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
  drive(simulation, 0, {2.0, 0.0}, 2.0);
  const std::vector<Contact> & contacts = simulation.contacts(0);
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
  EXPECT_NEAR(simulation.state(0).velocity.x, 0.0, 0.02);
  EXPECT_EQ(simulation.clearance(0, 5.0), 0.0);
}

class FastCrash : public ::testing::TestWithParam<double>
{
};

TEST_P(FastCrash, NeverPassesThroughTheWall)
{
  Simulation simulation(world({wallAcross(12.0)}));
  simulation.addCar(car("robot1"), {}, {0, 0, GetParam()});
  double farthest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    simulation.command(0, {GetParam() == 0.0 ? 20.0 : 15.0, 0.0});
    simulation.step();
    farthest = std::max(farthest, simulation.state(0).pose.x);
  }
  EXPECT_LT(farthest, 12.0 - 0.1);
  EXPECT_GT(farthest, 11.0);
}
INSTANTIATE_TEST_SUITE_P(Angles, FastCrash, ::testing::Values(0.0, 0.2, -0.5, 0.9));
}  // namespace f1tenth_sim2d::test
