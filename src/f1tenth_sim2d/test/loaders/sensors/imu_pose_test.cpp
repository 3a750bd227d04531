#include <gtest/gtest.h>

#include <cmath>

#include "core/components/imu/imu.h"
#include "f1tenth_sim2d/loaders.h"
#include "only.h"
#include "small_car.h"

// An IMU measures along the axes of the link that carries it, whatever its frame is called.
namespace f1tenth_sim2d
{
namespace
{
constexpr const char * kPlugin =
  "<gazebo><plugin name='p' filename='%'><topicName>imu</topicName><updateRate>50</updateRate>"
  "<bodyName>imu</bodyName>";

/// Yaw on the small car of the IMU that lies across it, rad.
double yawOfImu(std::string xml)
{
  const std::string child = "<child link=\"imu\"/>";
  xml.replace(xml.find(child), child.size(), child + "<origin rpy=\"0 0 1.5707963\"/>");
  return only<Imu>(loadCar(xml, "robot1", "car.urdf")).mount().pose.yaw();
}

std::string carWithPlugin(const std::string & library, const std::string & tags)
{
  std::string plugin = kPlugin;
  plugin.replace(plugin.find('%'), 1, library);
  std::string xml = smallCarWith("</robot>", plugin + tags + "</plugin></gazebo></robot>");
  const std::size_t sensor = xml.find("<gazebo reference=\"imu\">");
  return xml.erase(sensor, xml.find("</gazebo>", sensor) + std::string("</gazebo>").size() - sensor);
}

TEST(ImuPose, IsThatOfTheSensor)
{
  EXPECT_NEAR(yawOfImu(smallCar()), M_PI / 2, 1e-6);
}

TEST(ImuPose, IsThatOfTheBodyOfAPlugin)
{
  EXPECT_NEAR(yawOfImu(carWithPlugin("libgazebo_ros_imu.so", "")), M_PI / 2, 1e-6);
  const std::string frame = "<frameId>base_link</frameId>";
  EXPECT_NEAR(yawOfImu(carWithPlugin("libhector_gazebo_ros_imu.so", frame)), M_PI / 2, 1e-6);
}
}  // namespace
}  // namespace f1tenth_sim2d
