#include "../../src/bag_recorder/topics_of_cars.h"

#include <gtest/gtest.h>

namespace f1tenth_scenarios
{
using Names = std::set<std::string>;

TEST(TopicsOfCars, AreWhatTheirNodesPublishInAnyNamespace)
{
  const NodesByTopic publishers{
    {"/robot1/debug", {"/robot1/planner"}}, {"/steering_error", {"/robot1/planner"}}, {"/gazebo/links", {"/sim2d"}}};
  EXPECT_EQ(topicsOfCars(publishers, {}, {"robot1"}), (Names{"/robot1/debug", "/steering_error"}));
}

TEST(TopicsOfCars, AreWhatTheirNodesHear)
{
  const NodesByTopic publishers{{"/robot1/camera/image_raw", {"/sim2d"}}, {"/robot2/camera/image_raw", {"/sim2d"}}};
  const NodesByTopic subscribers{{"/robot1/camera/image_raw", {"/robot1/planner"}}};
  EXPECT_EQ(topicsOfCars(publishers, subscribers, {"robot1", "robot2"}), (Names{"/robot1/camera/image_raw"}));
}

TEST(TopicsOfCars, AreNoCostmaps)
{
  const Names node{"/robot1/move_base"};
  const NodesByTopic publishers{
    {"/robot1/move_base/local_costmap/costmap", node},
    {"/robot1/move_base/global_costmap/costmap_updates", node},
    {"/robot1/move_base/corridor", node}};
  EXPECT_EQ(topicsOfCars(publishers, {}, {"robot1"}), (Names{"/robot1/move_base/corridor"}));
}

TEST(TopicsOfCars, AreNotThoseOfACarWhoseNameBeginsTheSame)
{
  EXPECT_TRUE(topicsOfCars({{"/debug", {"/robot10/planner"}}}, {}, {"robot1"}).empty());
}
}  // namespace f1tenth_scenarios
