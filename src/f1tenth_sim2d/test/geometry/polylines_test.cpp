// Several <polyline> of one geometry: what an odd number of them enclose is solid, as in Gazebo.
#include <gtest/gtest.h>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/section.h"
#include "geometry/polygon_union.h"
#include "polygons.h"

namespace f1tenth_sim2d
{
namespace
{
Outline square(double low, double high)
{
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

/// Whether an odd number of outlines is around a point, as both the lidar and contacts see it.
bool isSolid(const Polyline & polyline, const Vec2 & point)
{
  int around = 0;
  for (const Outline & outline : polyline.outlines) {
    around += contains(outline, point) ? (signedArea(outline) > 0.0 ? 1 : -1) : 0;
  }
  bool touched = false;
  for (const ConvexPolygon & piece : polyline.pieces) {
    touched = touched || contains(piece, point);
  }
  EXPECT_EQ(around, touched ? 1 : 0) << point.x << ", " << point.y;
  return touched;
}

TEST(Polylines, ThatCrossAreSolidWhereOneIs)
{
  const Polyline polyline = extrude({square(0.0, 2.0), square(1.0, 3.0)}, 1.0);
  EXPECT_TRUE(isSolid(polyline, {0.5, 0.6}));
  EXPECT_TRUE(isSolid(polyline, {2.5, 2.6}));
  EXPECT_FALSE(isSolid(polyline, {1.5, 1.6}));
  EXPECT_NEAR(areaOf(polyline.outlines), 6.0, 1e-6);
  EXPECT_NEAR(areaOf(polyline.pieces), 6.0, 1e-3);
}

TEST(Polylines, MayTouchFromWithin)
{
  const Polyline polyline = extrude({square(0.0, 1.0), square(0.0, 2.0)}, 1.0);
  EXPECT_FALSE(isSolid(polyline, {0.5, 0.6}));
  EXPECT_TRUE(isSolid(polyline, {1.5, 1.6}));
  EXPECT_NEAR(areaOf(polyline.outlines), 3.0, 1e-6);
}

TEST(Polylines, MayTouchFromOutside)
{
  const Polyline polyline = extrude({square(0.0, 1.0), {{1, 0}, {2, 0}, {2, 1}, {1, 1}}}, 1.0);
  EXPECT_TRUE(isSolid(polyline, {0.5, 0.6}));
  EXPECT_TRUE(isSolid(polyline, {1.5, 0.6}));
  EXPECT_NEAR(areaOf(polyline.outlines), 2.0, 1e-6);
}

TEST(Polylines, ThatDoNotTouchKeepTheirCorners)
{
  const Polyline polyline = extrude({square(0.0, 0.3), square(0.1, 0.1 + 0.1)}, 1.0);
  ASSERT_EQ(polyline.outlines.size(), 2u);
  EXPECT_EQ(polyline.outlines[0].at(2).x, 0.3);
  EXPECT_LT(signedArea(polyline.outlines[1]), 0.0);
}

TEST(PolygonUnion, RefusesCornersThatItCannotHold)
{
  PolygonUnion area;
  try {
    area.add({{{0, 0}, {1e12, 0}, {0, 1e12}}});
    FAIL() << "nothing thrown";
  } catch (const Error & error) {
    EXPECT_STREQ(error.what(), "a corner of an area is at (1e+12, 0) m, allowed is at most 1e+11 m from the origin");
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
