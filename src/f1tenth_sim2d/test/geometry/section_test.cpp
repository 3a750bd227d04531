#include "f1tenth_sim2d/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "polygons.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Solid solid(Shape shape)
{
  return {"solid", std::move(shape), Pose3(), 1.0, 0.0};
}

const Solid kBox = solid(Box{{2.0, 1.0, 0.5}});
const Solid kCylinder = solid(Cylinder{0.5, 2.0});
const Solid kSphere = solid(Sphere{0.5});
const Solid kCorner = solid(extrude({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}, 1.0));

double area(const Section & section)
{
  return areaOf(section.outlines);
}

bool isEmpty(const Section & section)
{
  return section.outlines.empty() && section.circles.empty();
}

TEST(SectionOfBox, IsItsBaseTurnedAndMoved)
{
  const Section section = sectionAt(kBox, Pose3(3, 4, 0.25, 0, 0, M_PI / 2), 0.1);
  ASSERT_EQ(section.outlines.size(), 1u);
  ASSERT_EQ(section.outlines[0].size(), 4u);
  EXPECT_NEAR(area(section), 2.0, 1e-12);
  for (const Vec2 & corner : section.outlines[0]) {
    EXPECT_NEAR(std::abs(corner.x - 3.0), 0.5, 1e-12);
    EXPECT_NEAR(std::abs(corner.y - 4.0), 1.0, 1e-12);
  }
}

TEST(SectionOfBox, OwnsItsBottomButNotItsTop)
{
  const Pose3 on_the_ground(0, 0, 0.25, 0, 0, 0);
  EXPECT_NEAR(area(sectionAt(kBox, on_the_ground, 0.0)), 2.0, 1e-12);
  EXPECT_TRUE(isEmpty(sectionAt(kBox, on_the_ground, 0.5)));
  EXPECT_TRUE(isEmpty(sectionAt(kBox, on_the_ground, -0.001)));
  EXPECT_TRUE(isEmpty(sectionAt(kBox, on_the_ground, 0.501)));
}

TEST(SectionOfBox, StackedBoxesAreCutExactlyOnceAtTheirJoint)
{
  const double joint = 0.1 + 0.2;  // not representable: rounding must not open or double it
  const double below = area(sectionAt(kBox, Pose3(0, 0, joint - 0.25, 0, 0, 0), 0.3));
  const double above = area(sectionAt(kBox, Pose3(0, 0, joint + 0.25, 0, 0, 0), 0.3));
  EXPECT_NEAR(below + above, 2.0, 1e-12);
}

TEST(SectionOfBox, GrowsWhenTheBoxIsTilted)
{
  const Section section = sectionAt(solid(Box{{2.0, 1.0, 1.0}}), Pose3(0, 0, 0, M_PI / 4, 0, 0), 0.0);
  EXPECT_NEAR(area(section), 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(SectionOfBox, OfABoxOnItsCornerIsAHexagon)
{
  const Pose3 on_its_corner(0, 0, 0, std::atan(std::sqrt(2.0)), 0, 0);
  const Pose3 turned = on_its_corner * Pose3(0, 0, 0, 0, 0, M_PI / 4);
  const Section section = sectionAt(solid(Box{{1.0, 1.0, 1.0}}), turned, 0.0);
  ASSERT_EQ(section.outlines.size(), 1u);
  EXPECT_EQ(section.outlines[0].size(), 6u);
  EXPECT_NEAR(area(section), 3.0 * std::sqrt(3.0) / 4.0, 1e-9);
}

TEST(SectionOfBox, AnEdgeThatOnlyTouchesHasNone)
{
  const Pose3 on_its_edge(0, 0, std::sqrt(0.5), M_PI / 4, 0, 0);
  EXPECT_TRUE(isEmpty(sectionAt(solid(Box{{1.0, 1.0, 1.0}}), on_its_edge, 0.0)));
}

TEST(SectionOfCylinder, UprightIsAnExactCircle)
{
  for (const Pose3 & pose : {Pose3(1, 2, 1, 0, 0, 0.7), Pose3(1, 2, 1, M_PI, 0, 0)}) {
    const Section section = sectionAt(kCylinder, pose, 0.3);
    ASSERT_EQ(section.circles.size(), 1u);
    EXPECT_DOUBLE_EQ(section.circles[0].radius, 0.5);
    EXPECT_DOUBLE_EQ(section.circles[0].centre.x, 1.0);
    EXPECT_DOUBLE_EQ(section.circles[0].centre.y, 2.0);
    EXPECT_TRUE(section.outlines.empty());
  }
}

TEST(SectionOfCylinder, OwnsItsBottomButNotItsTop)
{
  EXPECT_FALSE(isEmpty(sectionAt(kCylinder, Pose3(0, 0, 1, 0, 0, 0), 0.0)));
  EXPECT_TRUE(isEmpty(sectionAt(kCylinder, Pose3(0, 0, 1, 0, 0, 0), 2.0)));
}

TEST(SectionOfCylinder, LyingIsARectangle)
{
  const Section section = sectionAt(kCylinder, Pose3(0, 0, 0, 0, M_PI / 2, 0), 0.3);
  ASSERT_EQ(section.outlines.size(), 1u);
  EXPECT_EQ(section.outlines[0].size(), 4u);
  EXPECT_NEAR(area(section), 2.0 * 2.0 * 0.4, 2.0 * 2.0 * 1e-4);  // either side within 0.1 mm
}

/// Greatest distance of the outline's corners and edge middles from the surface of a cylinder that leans towards +x.
double greatestDeviation(const Section & section, double lean, double z)
{
  double greatest = 0.0;
  const Outline & outline = section.outlines.at(0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 & a = outline[i];
    const Vec2 & b = outline[(i + 1) % outline.size()];
    const double x = (a.x + b.x) / 2.0;
    const double y = (a.y + b.y) / 2.0;
    const double along = x * std::sin(lean) + z * std::cos(lean);
    const double from_axis = std::hypot(x * std::cos(lean) - z * std::sin(lean), y);
    // Inside by less than the tolerance of the side, or on a cap.
    const double to_side = 0.5 - from_axis;
    const double to_cap = 1.0 - std::abs(along);
    greatest = std::max(greatest, std::min(std::abs(to_side), std::abs(to_cap)));
  }
  return greatest;
}

TEST(SectionOfCylinder, LeaningIsWithinATenthOfAMillimetre)
{
  for (const double lean : {1e-4, 0.01, 0.3, 0.8, 1.2, 1.5, 1.57, 1.5707}) {
    for (const double z : {-0.3, 0.0, 0.2, 0.45}) {
      const Section section = sectionAt(kCylinder, Pose3(0, 0, 0, 0, lean, 0), z);
      ASSERT_EQ(section.outlines.size(), 1u) << lean << " " << z;
      EXPECT_LT(greatestDeviation(section, lean, z), 1e-4) << lean << " " << z;
      EXPECT_LT(section.outlines[0].size(), 2000u) << lean << " " << z;
    }
  }
}

TEST(SectionOfSphere, IsACircleOfTheHeight)
{
  const Section section = sectionAt(kSphere, Pose3(1, 0, 0.5, 0.3, 0.2, 0.1), 0.2);
  ASSERT_EQ(section.circles.size(), 1u);
  EXPECT_NEAR(section.circles[0].radius, 0.4, 1e-12);
  EXPECT_TRUE(isEmpty(sectionAt(kSphere, Pose3(0, 0, 0.5, 0, 0, 0), 0.0)));
  EXPECT_TRUE(isEmpty(sectionAt(kSphere, Pose3(0, 0, 0.5, 0, 0, 0), 1.0)));
}

TEST(SectionOfPolyline, UprightKeepsItsOutlineInOnePiece)
{
  const Section section = sectionAt(kCorner, Pose3(5, 0, 0, 0, 0, 0), 0.5);
  ASSERT_EQ(section.outlines.size(), 1u);
  EXPECT_EQ(section.outlines[0].size(), 6u);
  EXPECT_NEAR(area(section), 3.0, 1e-12);
  EXPECT_TRUE(isEmpty(sectionAt(kCorner, Pose3(), 1.0)));
  EXPECT_FALSE(isEmpty(sectionAt(kCorner, Pose3(), 0.0)));
}

TEST(SectionOfPolyline, LyingIsACutThroughItsHeight)
{
  // Turned about x, its y points upwards: at height 0.5 it is 2 m wide, at 1.5 only 1 m; its height of 1 m lies along y.
  const Pose3 lying(0, 0, 0, M_PI / 2, 0, 0);
  EXPECT_NEAR(area(sectionAt(kCorner, lying, 0.5)), 2.0, 1e-9);
  EXPECT_NEAR(area(sectionAt(kCorner, lying, 1.5)), 1.0, 1e-9);
}

TEST(SectionOfPlane, IsEmpty)
{
  EXPECT_TRUE(isEmpty(sectionAt(solid(Plane{}), Pose3(), 0.0)));
}

TEST(SectionOfDegenerateSolid, IsEmpty)
{
  for (const Solid & flat :
       {solid(Box{{0, 1, 1}}), solid(Box{{1, 1, 0}}), solid(Cylinder{0, 1}), solid(Cylinder{1, 0}), solid(Sphere{0}),
        solid(extrude({{{0, 0}, {1, 0}, {2, 0}}}, 1)), solid(extrude({}, 1))}) {
    for (const Pose3 & pose : {Pose3(0, 0, 0, 0, 0, 0), Pose3(0, 0, 0, 0.3, 0.4, 0.5)}) {
      EXPECT_EQ(area(sectionAt(flat, pose, 0.0)), 0.0);
      EXPECT_TRUE(sectionAt(flat, pose, 0.0).circles.empty());
    }
  }
}

TEST(Footprint, OfAnUprightBoxIsItsBase)
{
  EXPECT_NEAR(area(footprintBetween(kBox, Pose3(0, 0, 0.25, 0, 0, 1), 0.1, 0.2)), 2.0, 1e-12);
}

TEST(Footprint, IsEmptyWhereTheSpanIsOnlyTouched)
{
  const Pose3 on_the_ground(0, 0, 0.25, 0, 0, 0);
  EXPECT_TRUE(isEmpty(footprintBetween(kBox, on_the_ground, 0.5, 1.0)));
  EXPECT_TRUE(isEmpty(footprintBetween(kBox, on_the_ground, -1.0, 0.0)));
  EXPECT_FALSE(isEmpty(footprintBetween(kBox, on_the_ground, 0.49, 1.0)));
  EXPECT_TRUE(isEmpty(footprintBetween(kSphere, on_the_ground, 0.75, 1.0)));
  EXPECT_TRUE(isEmpty(footprintBetween(kCylinder, Pose3(0, 0, 1, 0, 0, 0), 2.0, 3.0)));
}

TEST(Footprint, OfASphereIsItsWidestCircleInTheSpan)
{
  const Pose3 on_the_ground(0, 0, 0.5, 0, 0, 0);
  EXPECT_NEAR(footprintBetween(kSphere, on_the_ground, 0.0, 0.2).circles.at(0).radius, 0.4, 1e-12);
  EXPECT_NEAR(footprintBetween(kSphere, on_the_ground, 0.2, 0.7).circles.at(0).radius, 0.5, 1e-12);
  EXPECT_NEAR(footprintBetween(kSphere, on_the_ground, 0.8, 2.0).circles.at(0).radius, 0.4, 1e-12);
}

TEST(Footprint, OfALeaningBoxCoversOnlyWhatIsInTheSpan)
{
  // A plank that rises along +x: within the lowest decimetre it is only its lower end.
  const Solid plank = solid(Box{{2.0, 0.2, 0.01}});
  const Pose3 rising(0, 0, 0.5, 0, -M_PI / 6, 0);
  const double whole = area(footprintBetween(plank, rising, -kInfinity, kInfinity));
  const double low = area(footprintBetween(plank, rising, 0.0, 0.1));
  EXPECT_NEAR(whole, 0.2 * (2.0 * std::cos(M_PI / 6) + 0.01 * 0.5), 1e-9);
  EXPECT_LT(low, whole / 4.0);
  EXPECT_GT(low, 0.02);
}

TEST(Footprint, OfALyingCylinderIsARectangle)
{
  const Section whole = footprintBetween(kCylinder, Pose3(0, 0, 0, 0, M_PI / 2, 0), -kInfinity, kInfinity);
  EXPECT_NEAR(area(whole), 2.0, 1e-9);
  const Section low = footprintBetween(kCylinder, Pose3(0, 0, 0.5, 0, M_PI / 2, 0), 0.0, 0.2);
  EXPECT_NEAR(area(low), 2.0 * 0.8, 2.0 * 2.0 * 1e-4);
}

TEST(Footprint, OfALeaningCylinderContainsItsSections)
{
  const Pose3 leaning(0, 0, 0.6, 0, 0.5, 0);
  const double shadow = area(footprintBetween(kCylinder, leaning, 0.2, 0.6));
  for (const double z : {0.2, 0.4, 0.6}) {
    EXPECT_GT(shadow, area(sectionAt(kCylinder, leaning, z)));
  }
}

TEST(Footprint, OfAPolylineIsConvexPiecesOfItsArea)
{
  const Section footprint = footprintBetween(kCorner, Pose3(1, 1, 0, 0, 0, 0.4), 0.2, 0.3);
  EXPECT_EQ(footprint.outlines.size(), 2u);
  for (const ConvexPolygon & piece : footprint.outlines) {
    EXPECT_TRUE(isConvex(piece));
  }
  EXPECT_NEAR(area(footprint), 3.0, 1e-12);
}

TEST(Footprint, OfAPlaneIsEmpty)
{
  EXPECT_TRUE(isEmpty(footprintBetween(solid(Plane{}), Pose3(), -1.0, 1.0)));
}
}  // namespace
}  // namespace f1tenth_sim2d
