// What the limits of steering joints say of how far a car steers.
#include <gtest/gtest.h>

#include "f1tenth_sim2d/loaders.h"
#include "small_car.h"

namespace f1tenth_sim2d
{
namespace
{
CarDescription carWithLimits(const std::string & lower, const std::string & upper)
{
  std::string xml = smallCar();
  const std::string old = "lower=\"-0.4\" upper=\"0.4\"";
  for (std::size_t at = xml.find(old); at != std::string::npos; at = xml.find(old)) {
    xml.replace(at, old.size(), "lower='" + lower + "' upper='" + upper + "'");
  }
  return loadCar(xml, "robot1", "car.urdf");
}

bool warns(const CarDescription & car, const std::string & what)
{
  for (const std::string & warning : car.warnings) {
    if (warning.find(what) != std::string::npos) {
      return true;
    }
  }
  return false;
}

const char * const kOneSide = "turns to one side only: taken as one that turns as far to the other";

TEST(SteeringLimit, IsTheLesserOneOfBothSides)
{
  const CarDescription car = carWithLimits("-0.2", "0.3");
  EXPECT_EQ(car.parameters.steering_max, 0.2);
  EXPECT_FALSE(warns(car, kOneSide));
}

TEST(SteeringLimit, OfAJointThatTurnsToOneSideOnlyIsItsFarthestWithAWarning)
{
  for (const auto & [lower, upper] : {std::pair("0", "0.3"), std::pair("-0.3", "0"), std::pair("0.1", "0.3")}) {
    const CarDescription car = carWithLimits(lower, upper);
    EXPECT_EQ(car.parameters.steering_max, 0.3) << lower;
    EXPECT_TRUE(warns(car, kOneSide)) << lower;
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
