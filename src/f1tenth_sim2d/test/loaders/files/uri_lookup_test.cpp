#include "loaders/files/uri_lookup.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
/// A workspace with two packages, a folder of models and a world.
class Uris : public testing::Test
{
protected:
  Uris()
  {
    folder.write("src/group/car_description/package.xml", "<package><name> car_description </name></package>");
    folder.write("src/group/car_description/meshes/body.stl", "");
    folder.write("src/group/car_description/models/cone/model.config", "");
    folder.write(
      "src/places/package.xml",
      "<package><name>places</name><export><gazebo_ros gazebo_model_path='${prefix}/database:/nowhere' "
      "gazebo_media_path='${prefix}/media'/></export>"
      "</package>");
    folder.write("src/places/database/shelf/model.config", "");
    folder.write("src/places/media/meshes/shelf.dae", "");
    folder.write("src/places/models/chair/model.config", "");
    folder.write("models/table/model.config", "");
    folder.write("worlds/room.world", "");
    folder.write("worlds/models/lamp/model.config", "");
    folder.write("worlds/meshes/door.dae", "");
  }

  std::string find(const std::string & uri) const
  {
    const UriLookup uris({{folder.path() + "/models"}, {folder.path() + "/src"}}, folder.path() + "/worlds/room.world");
    const std::string found = uris.find(uri);
    return found.empty() ? "" : withoutFolder(found, folder);
  }

  TempFolder folder;
};

TEST_F(Uris, OfModelsAreFoundInModelFoldersAndBesideTheWorld)
{
  EXPECT_EQ(find("model://table"), "models/table");
  EXPECT_EQ(find("model://lamp"), "worlds/models/lamp");
  EXPECT_EQ(find("file://meshes/door.dae"), "worlds/meshes/door.dae");
}

TEST_F(Uris, OfModelsAreFoundInPackagesThatExportThemToGazebo)
{
  EXPECT_EQ(find("model://shelf"), "src/places/database/shelf");
  EXPECT_EQ(find("model://shelf/model.config"), "src/places/database/shelf/model.config");
}

TEST_F(Uris, OfModelsAreFoundInTheModelsFolderOfAPackage)
{
  EXPECT_EQ(find("model://chair"), "src/places/models/chair");
}

TEST_F(Uris, OfFilesAreFoundInResourceFolders)
{
  EXPECT_EQ(find("file://meshes/shelf.dae"), "src/places/media/meshes/shelf.dae");
  ::setenv("GAZEBO_MODEL_PATH", "/models", 1);
  ::setenv("GAZEBO_RESOURCE_PATH", (folder.path() + "/worlds").c_str(), 1);
  const SearchPath from_environment = searchPathFromEnvironment();
  ::unsetenv("GAZEBO_MODEL_PATH");
  ::unsetenv("GAZEBO_RESOURCE_PATH");
  EXPECT_EQ(from_environment.model_folders, (std::vector<std::string>{"/models", folder.path() + "/worlds"}));
  EXPECT_EQ(UriLookup(from_environment, "").find("file://meshes/door.dae"), folder.path() + "/worlds/meshes/door.dae");
}

TEST(SearchedFolders, NameWhatThereIs)
{
  const auto searched = [](const SearchPath & path) { return UriLookup(path, "").searchedFolders(); };
  EXPECT_EQ(searched({{"/models"}, {}}), "/models");
  EXPECT_EQ(searched({{"/models"}, {"/src"}}), "/models, and the ROS packages below /src");
  EXPECT_EQ(searched({{}, {"/src", "/share"}}), "the ROS packages below /src, /share");
}

TEST_F(Uris, NamePackages)
{
  EXPECT_EQ(find("package://car_description/meshes/body.stl"), "src/group/car_description/meshes/body.stl");
  EXPECT_EQ(find("model://car_description/meshes/body.stl"), "src/group/car_description/meshes/body.stl");
  EXPECT_EQ(find("model://car_description/models/cone"), "src/group/car_description/models/cone");
  EXPECT_EQ(find("package://car_description"), "src/group/car_description/");
}

TEST_F(Uris, ThatAreAbsoluteStayAsTheyAre)
{
  EXPECT_EQ(find("file://" + folder.path() + "/models/table"), "models/table");
  EXPECT_EQ(find("file:///nowhere/at/all"), "");
}

TEST_F(Uris, ThatAreNowhereAreNotFound)
{
  for (const char * const uri :
       {"model://nothing", "package://nothing/x", "package://places/nothing", "model://", ""}) {
    EXPECT_EQ(find(uri), "") << uri;
  }
}

TEST_F(Uris, DoNotReachIntoIgnoredOrHiddenFoldersNorIntoPackagesInPackages)
{
  folder.write("src/old/CATKIN_IGNORE", "");
  folder.write("src/old/gone/package.xml", "<package><name>gone</name></package>");
  folder.write("src/.hidden/secret/package.xml", "<package><name>secret</name></package>");
  folder.write("src/places/inner/package.xml", "<package><name>inner</name></package>");
  folder.write("src/broken/package.xml", "<package><name>broken");
  for (const char * const package : {"gone", "secret", "inner", "broken"}) {
    EXPECT_EQ(find(std::string("package://") + package), "") << package;
  }
}

TEST_F(Uris, OfTwoPackagesWithOneNameMeanTheFirst)
{
  folder.write("src/a/package.xml", "<package><name>places</name></package>");
  folder.write("src/a/x.stl", "");
  EXPECT_EQ(find("package://places/x.stl"), "src/a/x.stl");
}

TEST_F(Uris, EndInRingsOfLinks)
{
  std::filesystem::create_directory_symlink(folder.path() + "/src", folder.path() + "/src/loop");
  EXPECT_EQ(find("package://nothing"), "");
}
}  // namespace
}  // namespace f1tenth_sim2d
