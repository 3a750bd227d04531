#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "core/components/sonar/sonar.h"
#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "only.h"
#include "small_car.h"

// Sensors with libgazebo_ros_range.so.
namespace f1tenth_sim2d
{
namespace
{
/// The small car with a sonar at x = -0.1 m, 0.2 m above base_link, that looks backwards.
std::string carWithSonar(const std::string & before = "", const std::string & after = "")
{
  std::string sonar = R"(<link name="sonar"/>
<joint name="sonar_joint" type="fixed"><parent link="base_footprint"/><child link="sonar"/>
<origin xyz="-0.1 0 0.2" rpy="0 0 3.14159265"/></joint>
<gazebo reference="sonar"><sensor name="sonar" type="ray"><update_rate>40</update_rate><ray>
<scan><horizontal><samples>3</samples><min_angle>-0.2</min_angle><max_angle>0.2</max_angle></horizontal></scan>
<range><min>0.05</min><max>4.0</max></range></ray>
<plugin name="p" filename="libgazebo_ros_range.so"><topicName>echo</topicName><frameName>sonar</frameName>
<updateRate>20</updateRate><fov>0.4</fov><gaussianNoise>0.01</gaussianNoise></plugin></sensor></gazebo></robot>)";
  if (!before.empty()) {
    sonar.replace(sonar.find(before), before.size(), after);
  }
  return smallCarWith("</robot>", sonar);
}

CarDescription loadSonarCar(const std::string & xml)
{
  return loadCar(xml, "robot1", "test.urdf", {});
}

Sonar onlySonar(const std::string & xml)
{
  return only<Sonar>(loadSonarCar(xml));
}

std::string errorOfSonar(const std::string & xml)
{
  try {
    loadSonarCar(xml);
  } catch (const LoadError & error) {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(LoadSonar, IsThatOfTheDescription)
{
  const Sonar loaded = onlySonar(carWithSonar());
  EXPECT_EQ(loaded.mount().name, "sonar");
  EXPECT_EQ(loaded.mount().topic, "echo");
  EXPECT_EQ(loaded.mount().frame, "sonar");
  EXPECT_EQ(loaded.mount().rate_hz, 20.0);
  const Sonar::Options & sonar = loaded.options();
  EXPECT_NEAR(sonar.rays.origin.x, -0.1, 1e-9);
  EXPECT_NEAR(std::abs(sonar.rays.origin.yaw), M_PI, 1e-6);
  EXPECT_NEAR(sonar.rays.height, 0.2, 1e-9);
  EXPECT_EQ(sonar.rays.range_max, 4.0);
  ASSERT_EQ(sonar.rays.directions.size(), 3u);
  EXPECT_DOUBLE_EQ(sonar.rays.directions[0], -0.2);
  EXPECT_NEAR(sonar.rays.directions[1], 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(sonar.rays.directions[2], 0.2);
  EXPECT_EQ(sonar.range_min, 0.05);
  EXPECT_EQ(sonar.noise_stddev, 0.01);
  EXPECT_EQ(sonar.field_of_view, 0.4);
  EXPECT_FALSE(sonar.is_infrared);
}

TEST(LoadSonar, MayHaveOneRayAndBeInfrared)
{
  const Sonar one = onlySonar(carWithSonar("<samples>3<", "<samples>1<"));
  EXPECT_EQ(one.options().rays.directions, std::vector<double>{-0.2});
  EXPECT_TRUE(onlySonar(carWithSonar("<fov>", "<radiation>infrared</radiation><fov>")).options().is_infrared);
}

TEST(LoadSonar, MayBeUpsideDown)
{
  const Sonar turned = onlySonar(carWithSonar("rpy=\"0 0 ", "rpy=\"3.14 0 "));
  EXPECT_DOUBLE_EQ(turned.options().rays.directions[0], 0.2);
  EXPECT_DOUBLE_EQ(turned.options().rays.directions[2], -0.2);
}

TEST(LoadSonar, MeasuresAtTheLowerOfBothRates)
{
  EXPECT_EQ(onlySonar(carWithSonar("<updateRate>20</updateRate>", "")).mount().rate_hz, 40.0);
  EXPECT_EQ(onlySonar(carWithSonar("<updateRate>20<", "<updateRate>90<")).mount().rate_hz, 40.0);
  EXPECT_EQ(onlySonar(carWithSonar("<update_rate>40<", "<update_rate>0<")).mount().rate_hz, 20.0);
}

TEST(LoadSonar, MistakesAreNamed)
{
  const std::string place = "test.urdf: robot[small_car]/gazebo[sonar]/sensor[sonar]";
  const std::tuple<const char *, const char *, const char *> mistakes[]{
    {"<samples>3<", "<samples>0<", ": has 0 <samples>, allowed are 1 to 100000"},
    {"<min_angle>-0.2<", "<min_angle>0.3<", ": <min_angle> has to be less than <max_angle>, both within two turns"},
    {"<max>4.0<", "<max>0.01<", ": <range> has a <min> that is not less than its <max>"},
    {"rpy=\"0 0 ", "rpy=\"0 0.1 ", ": is tilted; a sonar has to be level, upright or upside down"},
    {"<update_rate>40<", "<update_rate>-1<", ": <update_rate> is -1, allowed are finite numbers from 0"},
    {"<updateRate>20<", "<updateRate>-1<", "/plugin[p]: <updateRate> is -1, allowed are finite numbers from 0"},
    {"<gaussianNoise>0.01<", "<gaussianNoise>-1<",
     "/plugin[p]: <gaussianNoise> is -1, allowed are finite numbers from 0"},
    {"<fov>0.4<", "<fov>-1<", "/plugin[p]: <fov> is -1, allowed are finite numbers from 0"},
  };
  for (const auto & [before, after, message] : mistakes) {
    EXPECT_EQ(errorOfSonar(carWithSonar(before, after)), place + message);
  }
}

TEST(LoadSonar, HasOneLayer)
{
  const CarDescription car =
    loadSonarCar(carWithSonar("</horizontal>", "</horizontal><vertical><samples>4</samples></vertical>"));
  EXPECT_NE(
    car.warnings.back().find("sensor[sonar]: <vertical> is left out: a sonar has one level layer"), std::string::npos);
}
}  // namespace f1tenth_sim2d
