// What Localizer makes of inputs at the edge of sense and beyond.
#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <limits>
#include <memory>
#include <string>

#include "amcl/localizer.h"
#include "rooms.h"

namespace amcl
{
namespace
{
class LocalizerInputs : public testing::Test
{
protected:
  static std::unique_ptr<Localizer> make(const LocalizerOptions & options = {})
  {
    return Localizer::make(room(), options, {{-2.0, -0.5, 0.0}, {0.01, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0025}});
  }
  static std::string complaint(Localizer & localizer, const Scan & scan, const Pose2 & odometry)
  {
    try {
      localizer.process(scan, {}, odometry);
    } catch (const Error & error) {
      return error.what();
    }
    return "";
  }

  const Scan scan_{scanOn(room(), {-2.0, -0.5, 0.0})};
};

TEST_F(LocalizerInputs, EveryQuantileThatMayBeAskedForWorks)
{
  for (const double quantile : {0.0, 8.0}) {
    LocalizerOptions options;
    options.kld_z = quantile;
    options.resample_interval = 1;
    const auto localizer = make(options);
    for (int i = 0; i < 3; ++i) {
      localizer->process(scan_, {}, {0.21 * i, 0.0, 0.0});
    }
    EXPECT_GE(localizer->particles().size(), 100U);
    EXPECT_LE(localizer->particles().size(), 5000U);
  }
}

TEST_F(LocalizerInputs, ScanThatDoesNotSayWhereItsBeamsAreIsRefused)
{
  const auto localizer = make();
  Scan scan = scan_;
  scan.angle_increment = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint(*localizer, scan, {}), "angle_increment: found nan, must be a finite number other than 0");
  EXPECT_EQ(localizer->process(scan_, {}, {}), Outcome::kUpdated);
  EXPECT_NEAR(localizer->estimate().pose.x, -2.0, 0.05);
}

TEST_F(LocalizerInputs, OdometryMayLeap)
{
  for (const double leap : {5.0, 9e5}) {
    const auto localizer = make();
    localizer->process(scan_, {}, {});
    EXPECT_NO_THROW(localizer->process(scan_, {}, {leap, 0.0, 0.0})) << leap;
    EXPECT_NO_THROW(localizer->estimate().validate()) << leap;
  }
}

TEST_F(LocalizerInputs, OdometryThatLeapsOffTheEarthIsRefused)
{
  const auto localizer = make();
  localizer->process(scan_, {}, {});
  EXPECT_EQ(complaint(*localizer, scan_, {1e100, 0.0, 0.0}), "way of odometry: found 1e+100, must be at most 1e+06");
  EXPECT_NEAR(localizer->estimate().pose.x, -2.0, 0.05);
}
}  // namespace
}  // namespace amcl
