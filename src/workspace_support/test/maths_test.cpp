#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "workspace_support/maths/exponential.h"
#include "workspace_support/maths/random.h"
#include "workspace_support/maths/trigonometry.h"

std::uint64_t bitsOfAnyProcessor();
#ifdef MATHS_WITH_FMA
std::uint64_t bitsWithFma();
#endif

namespace workspace_support::maths::test
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kPlaces = 100000;

/// Distance in units of the last place of the right value.
double ulps(double value, long double right)
{
  const auto nearest = static_cast<double>(right);
  const double unit = std::nextafter(std::abs(nearest), kInfinity) - std::abs(nearest);
  return static_cast<double>(std::abs(value - right)) / unit;
}

class AngleUpTo : public ::testing::TestWithParam<double>
{
};

TEST_P(AngleUpTo, HasTheSineCosineAndTangentOfTheCLibrary)
{
  Random random(3);
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = random.uniform(-GetParam(), GetParam());
    const SineCosine at = sineCosine(angle);
    ASSERT_NEAR(at.sine, std::sin(static_cast<long double>(angle)), 2.4e-16) << angle;
    ASSERT_NEAR(at.cosine, std::cos(static_cast<long double>(angle)), 2.4e-16) << angle;
    ASSERT_EQ(sin(angle), at.sine);
    ASSERT_EQ(cos(angle), at.cosine);
  }
}
INSTANTIATE_TEST_SUITE_P(Radians, AngleUpTo, ::testing::Values(0.8, 3.2, 100.0, 99999.0));

TEST(SineCosine, OfWholeQuarterTurnsIsExactToRounding)
{
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const SineCosine at = sineCosine(quarter * (M_PI / 2));
    EXPECT_NEAR(at.sine, std::sin(quarter * (M_PI / 2)), 1.2e-16) << quarter;
    EXPECT_NEAR(at.cosine, std::cos(quarter * (M_PI / 2)), 1.2e-16) << quarter;
  }
  EXPECT_EQ(sineCosine(0.0).sine, 0.0);
  EXPECT_EQ(sineCosine(0.0).cosine, 1.0);
}

TEST(SineCosine, OfAHugeAngleIsStillOnTheCircle)
{
  for (const double angle : {1e6, -3e9, 1e15}) {
    const SineCosine at = sineCosine(angle);
    EXPECT_NEAR(at.sine * at.sine + at.cosine * at.cosine, 1.0, 5e-16) << angle;
  }
}

TEST(SineCosine, OfWhatIsNotFiniteIsNotANumber)
{
  for (const double angle : {kNan, kInfinity}) {
    EXPECT_TRUE(std::isnan(sineCosine(angle).sine));
    EXPECT_TRUE(std::isnan(sineCosine(angle).cosine));
  }
}

TEST(Tangent, IsWithin4Ulp)
{
  Random random(4);
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = random.uniform(-1.5, 1.5);
    ASSERT_LE(ulps(tan(angle), std::tan(static_cast<long double>(angle))), 4.0) << angle;
  }
}

TEST(ArcTangent, AgreesWithTheCLibraryAllAround)
{
  Random random(4);
  for (int i = 0; i < kPlaces; ++i) {
    const double y = std::pow(10.0, random.uniform(-8.0, 8.0)) * random.uniform(-1.0, 1.0);
    const double x = random.uniform(-1.0, 1.0);
    ASSERT_NEAR(atan2(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
    ASSERT_EQ(atan(y), atan2(y, 1.0));
  }
}

TEST(ArcTangent, AlongTheAxesIsThatOfTheCLibrary)
{
  for (const auto & [y, x] : {std::pair{0.0, 1.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, -1.0}, {1.0, 1.0}, {-1.0, -1.0}}) {
    EXPECT_NEAR(atan2(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
  }
  EXPECT_EQ(atan2(0.0, 0.0), 0.0);
}

TEST(ArcSine, AgreesWithTheCLibraryAndEndsAtOne)
{
  Random random(5);
  for (int i = 0; i < kPlaces; ++i) {
    const double x = random.uniform(-1.0, 1.0);
    ASSERT_NEAR(asin(x), std::asin(x), 1e-15) << x;
    ASSERT_NEAR(acos(x), std::acos(x), 1e-15) << x;
  }
  EXPECT_NEAR(asin(1.0), M_PI_2, 1e-16);
  EXPECT_NEAR(acos(-1.0), M_PI, 1e-15);
  EXPECT_EQ(acos(1.0), 0.0);
  EXPECT_TRUE(std::isnan(asin(1.1)));
  EXPECT_TRUE(std::isnan(acos(-1.1)));
}

TEST(Hypotenuse, IsWithin1AndAHalfUlp)
{
  Random random(6);
  for (int i = 0; i < kPlaces; ++i) {
    const double x = random.uniform(-10.0, 10.0);
    const double y = random.uniform(-1.0, 1.5);
    ASSERT_LE(ulps(hypot(x, y), std::hypot(static_cast<long double>(x), static_cast<long double>(y))), 1.5);
  }
}

TEST(Exponential, IsWithin1Ulp)
{
  Random random(7);
  for (const double range : {1e-3, 1.0, 700.0}) {
    for (int i = 0; i < kPlaces; ++i) {
      const double x = random.uniform(-range, range);
      ASSERT_LE(ulps(exp(x), std::exp(static_cast<long double>(x))), 1.0) << x;
    }
  }
}

TEST(Exponential, EndsWhereDoublesDo)
{
  EXPECT_EQ(exp(0.0), 1.0);
  EXPECT_EQ(exp(710.0), kInfinity);
  EXPECT_EQ(exp(kInfinity), kInfinity);
  EXPECT_EQ(exp(-746.0), 0.0);
  EXPECT_EQ(exp(-kInfinity), 0.0);
  EXPECT_NEAR(exp(-740.0) / std::exp(-740.0), 1.0, 1e-2);  // subnormal
  EXPECT_TRUE(std::isnan(exp(kNan)));
}

TEST(Logarithm, IsWithin1Ulp)
{
  Random random(8);
  for (int i = 0; i < kPlaces; ++i) {
    const double x = std::exp(random.uniform(-700.0, 700.0));
    ASSERT_LE(ulps(log(x), std::log(static_cast<long double>(x))), 1.0) << x;
    const double near_one = random.uniform(0.5, 2.0);
    ASSERT_LE(ulps(log(near_one), std::log(static_cast<long double>(near_one))), 1.0) << near_one;
  }
}

TEST(Logarithm, OfWhatIsNotPositiveIsThatOfTheCLibrary)
{
  EXPECT_EQ(log(0.0), -kInfinity);
  EXPECT_EQ(log(1.0), 0.0);
  EXPECT_EQ(log(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(log(-1.0)));
  EXPECT_TRUE(std::isnan(log(kNan)));
}

TEST(Power, IsAsExactAsItSays)
{
  Random random(9);
  for (int i = 0; i < kPlaces; ++i) {
    const double x = random.uniform(1e-3, 1e3);
    const double y = random.uniform(-5.0, 5.0);
    const double bound = (2.0 + std::abs(y * std::log(x))) * 2e-16;
    ASSERT_NEAR(pow(x, y) / std::pow(static_cast<long double>(x), static_cast<long double>(y)), 1.0, bound);
  }
}

TEST(CubeRoot, IsWithin2Ulp)
{
  Random random(10);
  for (int i = 0; i < kPlaces; ++i) {
    const double x = random.uniform(-1e3, 1e3);
    ASSERT_LE(ulps(cbrt(x), std::cbrt(static_cast<long double>(x))), 2.0) << x;
  }
  EXPECT_EQ(cbrt(0.0), 0.0);
  EXPECT_EQ(cbrt(-kInfinity), -kInfinity);
}

TEST(Random, HasTheMomentsOfItsDistributions)
{
  Random random(11);
  double sum = 0.0, squares = 0.0, uniform = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double x = random.gaussian();
    sum += x;
    squares += x * x;
    uniform += random.uniform();
  }
  EXPECT_NEAR(sum / kPlaces, 0.0, 0.01);
  EXPECT_NEAR(squares / kPlaces, 1.0, 0.02);
  EXPECT_NEAR(uniform / kPlaces, 0.5, 0.01);
}

TEST(Maths, HasTheseBitsOnEveryMachine)
{
  EXPECT_EQ(bitsOfAnyProcessor(), 6040367805763890566U);
#ifdef MATHS_WITH_FMA
  if (!__builtin_cpu_supports("fma")) {
    GTEST_SKIP() << "this processor has no fused multiply-add";
  }
  EXPECT_EQ(bitsWithFma(), bitsOfAnyProcessor());
#endif
}
}  // namespace workspace_support::maths::test
