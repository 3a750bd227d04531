#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/section.h"
#include "loaders/shapes/mesh_file.h"
#include "mesh_files.h"
#include "polygons.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{

/// What the mesh of an OBJ text looks like.
class MeshSection : public testing::Test
{
protected:
  Solid solid(const std::string & obj, const MeshSelection & selection = {}) const
  {
    return {"m::l::c", Mesh{readMeshFile(folder.write("mesh.obj", obj), selection).triangles}, Pose3(), 1.0, 0.0};
  }

  static double areaAt(const Solid & solid, double z) { return areaOf(sectionAt(solid, Pose3(), z).outlines); }

  static double shadowArea(const Solid & solid, double z_min, double z_max)
  {
    const Section shadow = footprintBetween(solid, Pose3(), z_min, z_max);
    for (const Outline & piece : shadow.outlines) {
      EXPECT_TRUE(isConvex(piece));
    }
    return areaOf(shadow.outlines);
  }

  TempFolder folder;
  const std::string kBlock = objBox("block", {0, 0, 0}, {2, 1, 0.5});
};

TEST_F(MeshSection, OfABoxIsItsBaseWithFourCorners)
{
  const Section section = sectionAt(solid(kBlock), Pose3(3, 0, 0, 0, 0, M_PI / 2), 0.2);
  ASSERT_EQ(section.outlines.size(), 1u);
  EXPECT_EQ(section.outlines[0].size(), 4u);
  EXPECT_NEAR(areaOf(section.outlines), 2.0, 1e-9);
  for (const Vec2 & corner : section.outlines[0]) {
    EXPECT_NEAR(std::abs(corner.x - 2.5), 0.5, 1e-9);
  }
}

TEST_F(MeshSection, OwnsItsLowestHeightButNotItsHighest)
{
  const Solid block = solid(kBlock);
  EXPECT_NEAR(areaAt(block, 0.0), 2.0, 1e-9);
  EXPECT_EQ(areaAt(block, 0.5), 0.0);
  EXPECT_EQ(areaAt(block, -0.01), 0.0);
}

TEST_F(MeshSection, OfATiltedBoxIsThatOfTheExactSolid)
{
  const Solid mesh = solid(objBox("block", {-1, -0.5, -0.25}, {1, 0.5, 0.25}));
  const Solid box{"m::l::c", Box{{2, 1, 0.5}}, Pose3(), 1.0, 0.0};
  for (const double roll : {0.1, 0.7, 1.5, 2.9}) {
    const Pose3 pose(1, 2, 0.3, roll, 0.4, 0.8);
    for (const double z : {0.05, 0.3, 0.55}) {
      EXPECT_NEAR(areaOf(sectionAt(mesh, pose, z).outlines), areaOf(sectionAt(box, pose, z).outlines), 1e-9);
    }
    const double exact = areaOf(footprintBetween(box, pose, 0.0, 0.2).outlines);
    EXPECT_NEAR(areaOf(footprintBetween(mesh, pose, 0.0, 0.2).outlines), exact, 2e-4 * exact);
  }
}

TEST_F(MeshSection, OfATubeHasAHollow)
{
  const Solid tube = solid(kBlock + objHollow("inside", {0.5, 0.25, 0}, {1.5, 0.75, 0.5}, 9));
  const Section section = sectionAt(tube, Pose3(), 0.2);
  ASSERT_EQ(section.outlines.size(), 2u);
  EXPECT_NEAR(areaOf(section.outlines), 1.5, 1e-9);
  EXPECT_NEAR(shadowArea(tube, 0.1, 0.2), 1.5, 1e-4);
}

TEST_F(MeshSection, OfARoomSeenFromInsideIsWallsOnly)
{
  const Solid room = solid(objHollow("room", {0, 0, 0}, {4, 4, 2}));
  const Section walls = sectionAt(room, Pose3(), 0.2);
  EXPECT_EQ(walls.outlines.size(), 1u);
  EXPECT_EQ(areaOf(walls.outlines), 0.0);  // there and back: a lidar outside sees them, too
  EXPECT_NEAR(shadowArea(room, 0.1, 0.2), 16.0 * 0.001, 1e-5);
}

TEST_F(MeshSection, OfAnUprightSheetGoesThereAndBack)
{
  const Solid sheet = solid("v 0 0 0\nv 2 0 0\nv 2 0 1\nv 0 0 1\nf 1 2 3 4\n");
  const Section section = sectionAt(sheet, Pose3(), 0.5);
  ASSERT_EQ(section.outlines.size(), 1u);
  EXPECT_EQ(section.outlines[0].size(), 4u);  // the middle lies on the diagonal of the two triangles
  EXPECT_EQ(areaOf(section.outlines), 0.0);
  EXPECT_NEAR(shadowArea(sheet, 0.1, 0.2), 2.0 * 0.001, 1e-6);
  EXPECT_EQ(shadowArea(sheet, 1.0, 1.2), 0.0);
}

TEST_F(MeshSection, OfTwoSidedFacesIsSolid)
{
  const std::string inside = objHollow("inside", {0, 0, 0}, {2, 1, 0.5}, 9);
  EXPECT_NEAR(areaAt(solid(kBlock + inside), 0.2), 2.0, 1e-9);
}

TEST_F(MeshSection, ShadowOfATableIsItsTopOrItsLegsAsTheSpanHasIt)
{
  const Solid table = solid(
    objBox("top", {0, 0, 0.7}, {2, 1, 0.75}) + objBox("left", {0, 0, 0}, {0.1, 0.1, 0.7}, 9) +
    objBox("right", {1.9, 0.9, 0}, {2, 1, 0.7}, 17));
  EXPECT_NEAR(shadowArea(table, 0.0, 0.3), 0.02, 1e-5);
  EXPECT_NEAR(shadowArea(table, 0.0, 0.72), 2.0, 1e-4);
  EXPECT_NEAR(areaAt(table, 0.2), 0.02, 1e-7);  // a file holds 32 bit floats
  EXPECT_NEAR(areaAt(table, 0.72), 2.0, 1e-9);
}

TEST_F(MeshSection, ShadowOfOverlappingPartsCountsOnce)
{
  const Solid cross = solid(objBox("a", {-1, -0.1, 0}, {1, 0.1, 1}) + objBox("b", {-0.1, -1, 0}, {0.1, 1, 1}, 9));
  EXPECT_NEAR(shadowArea(cross, 0.2, 0.4), 0.76, 1e-4);
}

TEST_F(MeshSection, ShadowOfAHeapIsWhereAnyOfItsTrianglesIs)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> across(0.0, 4.0), around(-0.2, 0.2);
  std::ostringstream obj;
  std::vector<Outline> triangles;
  obj << "o heap\n";
  for (int i = 0; i < 1000; ++i) {
    const Vec2 place{across(generator), across(generator)};
    Outline & triangle = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      triangle.push_back({place.x + around(generator), place.y + around(generator)});
      obj << "v " << triangle.back().x << " " << triangle.back().y << " " << 0.1 + i * 1e-4 << "\n";
    }
    obj << "f " << 3 * i + 1 << " " << 3 * i + 2 << " " << 3 * i + 3 << "\n";
  }
  const std::vector<Outline> pieces = footprintBetween(solid(obj.str()), Pose3(), 0.0, 1.0).outlines;
  int differing = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec2 point{across(generator), across(generator)};
    const auto has_point = [&point](const Outline & polygon) { return contains(polygon, point); };
    differing += std::any_of(pieces.begin(), pieces.end(), has_point) !=
                 std::any_of(triangles.begin(), triangles.end(), has_point);
  }
  EXPECT_LE(differing, 20);  // edges are within 0.05 mm
}

TEST_F(MeshSection, IsScaledAndMirrored)
{
  MeshSelection selection;
  selection.scale = {-2, 1, 4};
  const Solid mirrored = solid(kBlock, selection);
  EXPECT_NEAR(areaAt(mirrored, 1.9), 4.0, 1e-9);
  const Section section = sectionAt(mirrored, Pose3(), 1.9);
  for (const Vec2 & corner : section.outlines.at(0)) {
    EXPECT_LE(corner.x, 0.0);
  }
}

TEST_F(MeshSection, TakesOneSubmeshAndCentresIt)
{
  const std::string two = kBlock + objBox("post", {5, 5, 0}, {5.2, 5.2, 2}, 9);
  MeshSelection selection;
  selection.submesh = "post";
  EXPECT_NEAR(areaAt(solid(two, selection), 1.0), 0.04, 1e-6);
  EXPECT_NEAR(sectionAt(solid(two, selection), Pose3(), 1.0).outlines.at(0).at(0).x, 5.1, 0.11);
  selection.centred = true;
  EXPECT_NEAR(std::abs(sectionAt(solid(two, selection), Pose3(), 0.9).outlines.at(0).at(0).x), 0.1, 1e-6);
  EXPECT_EQ(areaAt(solid(two, selection), 1.1), 0.0);
}

TEST_F(MeshSection, OfADaeIsInItsUnitsWhateverItsUpAxis)
{
  for (const char * const axis : {"Z_UP", "Y_UP"}) {
    const std::string asset = std::string("<unit meter='0.5'/><up_axis>") + axis + "</up_axis>";
    const Mesh mesh{readMeshFile(folder.write("peak.dae", daeTetrahedron(asset)), {}).triangles};
    const Solid peak{"m::l::c", mesh, Pose3(), 1.0, 0.0};
    EXPECT_NEAR(areaAt(peak, 0.25), 0.5 * 0.25 * 0.25, 1e-9) << axis;
    EXPECT_EQ(areaAt(peak, 0.51), 0.0) << axis;
  }
}

TEST_F(MeshSection, OfAnStlIsInMetres)
{
  const std::string stl =
    "solid peak\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid peak\n";
  const Solid peak{"m::l::c", Mesh{readMeshFile(folder.write("peak.stl", stl), {}).triangles}, Pose3(), 1.0, 0.0};
  EXPECT_NEAR(areaAt(peak, 0.5), 0.125, 1e-9);
  EXPECT_NEAR(shadowArea(peak, 0.5, 2.0), 0.125, 1e-5);
}

TEST_F(MeshSection, OfAnotherPartOfAFileDoesNotReadItAgainUnlessItHasChanged)
{
  const std::string path = folder.write("mesh.obj", kBlock + objBox("post", {5, 5, 0}, {5.2, 5.2, 2}, 9));
  const auto written = std::filesystem::last_write_time(path);
  EXPECT_EQ(readMeshFile(path, {}).triangles->triangles.size(), 24u);
  folder.write("mesh.obj", "nothing that could be read");
  std::filesystem::last_write_time(path, written);
  MeshSelection post;
  post.submesh = "post";
  EXPECT_EQ(readMeshFile(path, post).triangles->triangles.size(), 12u);
  std::filesystem::last_write_time(path, written + std::chrono::seconds(1));
  EXPECT_THROW(readMeshFile(path, post), Error);
}

std::string meshErrorOf(const std::string & path, const MeshSelection & selection = {})
{
  try {
    readMeshFile(path, selection);
  } catch (const Error & error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST_F(MeshSection, ErrorsSayWhatIsWrongWithTheFile)
{
  EXPECT_EQ(meshErrorOf(folder.write("no.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n")), "holds no triangles");
  EXPECT_EQ(meshErrorOf(folder.write("no.dae", "<COLLADA>")).rfind("cannot be read: ", 0), 0u);
  EXPECT_EQ(meshErrorOf(folder.write("no.stl", "")), "cannot be read: the file is empty");
  EXPECT_EQ(meshErrorOf(folder.write("no.stl", std::string(200, 'x'))).find("magic"), std::string::npos)
    << "is what Assimp calls a file in memory";
  EXPECT_EQ(
    meshErrorOf(folder.write("far.obj", "v 0 0 0\nv 1e6 0 0\nv 0 1 0\nf 1 2 3\n")),
    "holds no triangles within 100 km of its origin");
  MeshSelection lid;
  lid.submesh = "lid";
  EXPECT_NE(
    meshErrorOf(folder.write("block.obj", kBlock), lid).find("has no submesh 'lid', there are: "), std::string::npos);
  EXPECT_NE(meshErrorOf(folder.write("block.obj", kBlock), lid).find("block"), std::string::npos);
}
}  // namespace
}  // namespace f1tenth_sim2d
