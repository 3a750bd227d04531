#include "core/math/trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace f1tenth_sim2d::test
{
constexpr double kUlp = 1.2e-16;  // of numbers just below 1

class SineCosineUpTo : public ::testing::TestWithParam<double>
{
};

TEST_P(SineCosineUpTo, AgreesWithTheCLibrary)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angles(-GetParam(), GetParam());
  for (int i = 0; i < 100000; ++i) {
    const double angle = angles(random);
    const SineCosine at = sineCosine(angle);
    ASSERT_NEAR(at.sine, std::sin(angle), 2 * kUlp) << angle;
    ASSERT_NEAR(at.cosine, std::cos(angle), 2 * kUlp) << angle;
  }
}
INSTANTIATE_TEST_SUITE_P(Radians, SineCosineUpTo, ::testing::Values(0.8, 3.2, 100.0, 99999.0));

TEST(SineCosine, OfWholeQuarterTurnsIsExactToRounding)
{
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const SineCosine at = sineCosine(quarter * (M_PI / 2));
    EXPECT_NEAR(at.sine, std::sin(quarter * (M_PI / 2)), kUlp) << quarter;
    EXPECT_NEAR(at.cosine, std::cos(quarter * (M_PI / 2)), kUlp) << quarter;
  }
  EXPECT_EQ(sineCosine(0.0).sine, 0.0);
  EXPECT_EQ(sineCosine(0.0).cosine, 1.0);
}

TEST(SineCosine, OfAHugeAngleIsStillOnTheCircle)
{
  for (const double angle : {1e6, -3e9, 1e15}) {
    const SineCosine at = sineCosine(angle);
    EXPECT_NEAR(at.sine * at.sine + at.cosine * at.cosine, 1.0, 4 * kUlp) << angle;
  }
}

TEST(SineCosine, OfWhatIsNotFiniteIsNotANumber)
{
  for (const double angle : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(sineCosine(angle).sine));
    EXPECT_TRUE(std::isnan(sineCosine(angle).cosine));
  }
}

TEST(Direction, AgreesWithTheCLibraryAllAround)
{
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> coordinates(-1.0, 1.0);
  for (int i = 0; i < 100000; ++i) {
    const double scale = std::pow(10.0, 8.0 * coordinates(random));
    const double y = scale * coordinates(random);
    const double x = coordinates(random);
    ASSERT_NEAR(direction(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
  }
}

TEST(Direction, AlongTheAxesIsThatOfTheCLibrary)
{
  for (const auto & [y, x] : {std::pair{0.0, 1.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, -1.0}, {1.0, 1.0}, {-1.0, -1.0}}) {
    EXPECT_NEAR(direction(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
  }
  EXPECT_EQ(direction(0.0, 0.0), 0.0);
}
}  // namespace f1tenth_sim2d::test
