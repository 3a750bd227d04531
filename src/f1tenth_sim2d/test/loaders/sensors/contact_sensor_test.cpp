// Which collision a contact sensor means.
#include <gtest/gtest.h>

#include "f1tenth_sim2d/loaders.h"
#include "small_car.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
using Names = std::vector<std::string>;

std::string link(const std::string & name, const std::string & collision, const std::string & sensor)
{
  return "<link name='" + name + "'><collision name='" + collision +
         "'><geometry><box><size>1 1 1</size></box></geometry></collision>" + sensor + "</link>";
}

/// A car whose sensor stands on the link `bumper`, and whose links all have a `collision`.
std::string carWatching(const std::string & collision)
{
  const std::string sensor = "<sensor name='s' type='contact'><contact><collision>" + collision +
                             "</collision></contact><plugin name='p' filename='libgazebo_ros_bumper.so'>"
                             "<bumperTopicName>b</bumperTopicName><frameName>f</frameName></plugin></sensor>";
  return "<sdf version='1.6'><model name='car'>" + link("base_link", "collision", "") +
         link("bumper", "collision", sensor) + link("tail", "end", "") + link("nose", "tip", "") +
         link("left", "side", "") + link("right", "side", "") + "</model></sdf>";
}

Names watched(const std::string & xml)
{
  return loadCar(xml, "r", "car.sdf").bumpers.at(0).collision_names;
}

std::string error(const std::string & collision)
{
  return loadErrorOf([&collision] { loadCar(carWatching(collision), "r", "car.sdf"); });
}

TEST(ContactSensor, MeansACollisionOfItsOwnLinkFirst)
{
  EXPECT_EQ(watched(carWatching("collision")), Names{"r::bumper::collision"});
  EXPECT_EQ(watched(carWatching("end")), Names{"r::tail::end"});
}

TEST(ContactSensor, MeansTheLinkThatTheScopeNames)
{
  EXPECT_EQ(watched(carWatching("bumper::collision")), Names{"r::bumper::collision"});
  EXPECT_EQ(watched(carWatching("base_link::collision")), Names{"r::base_link::collision"});
  EXPECT_EQ(watched(carWatching("car::base_link::collision")), Names{"r::base_link::collision"});
  EXPECT_EQ(watched(carWatching("r::base_link::collision")), Names{"r::base_link::collision"});
}

TEST(ContactSensor, MayNameALinkThatAFixedJointHasJoined)
{
  const std::string own = "<collision>bumper_left_collision</collision>";
  const Names expected{"robot1::base_footprint::base_footprint_fixed_joint_lump__bumper_left_collision_1"};
  const auto watches = [&own](const std::string & name) {
    const std::string xml = smallCarWith(own, "<collision>" + name + "</collision>");
    for (const BumperDescription & bumper : loadCar(xml, "robot1", "car.urdf").bumpers) {
      if (bumper.name == "bumper_left") {
        return bumper.collision_names;
      }
    }
    return Names{};
  };
  EXPECT_EQ(watches("bumper_left_collision"), expected);
  EXPECT_EQ(watches("bumper_left::bumper_left_collision"), expected);
  EXPECT_EQ(watches("small_car::bumper_left::bumper_left_collision"), expected);
}

TEST(ContactSensor, RefusesACollisionThatIsNotThere)
{
  const std::string has =
    "; the car has base_link::collision, bumper::collision, tail::end, nose::tip, left::side, right::side";
  for (const std::string name :
       {"nosuchlink::collision", "other::bumper::collision", "umper::collision", "tail::tip"}) {
    EXPECT_EQ(error(name), "car.sdf: model[car]/link[bumper]/sensor[s]: there is no <collision> '" + name + "'" + has);
  }
}

TEST(ContactSensor, RefusesACollisionOfSeveralOtherLinks)
{
  EXPECT_EQ(
    error("side"),
    "car.sdf: model[car]/link[bumper]/sensor[s]: <collision> 'side' is in left::side and right::side; write which");
}
}  // namespace
}  // namespace f1tenth_sim2d
