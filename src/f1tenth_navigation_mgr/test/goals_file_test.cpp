#include "f1tenth_navigation_mgr/goals_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using namespace f1tenth_navigation_mgr;

namespace
{
const std::string kForms{R"("x y yaw" or "x y z qx qy qz qw")"};

std::string loadErrorOf(const std::string & path)
{
  try {
    LoadGoalsFile(path);
  } catch (const GoalsFileError & error) {
    return error.what();
  }
  return "no error";
}

class GoalsFile : public ::testing::Test
{
public:
  GoalsFile()
  {
    std::string name{(fs::temp_directory_path() / "goals_file_test_XXXXXX").string()};
    folder_ = mkdtemp(name.data());
  }
  ~GoalsFile() override { fs::remove_all(folder_); }

protected:
  std::string path(const std::string & name) const { return (folder_ / name).string(); }

  Goals read(const std::string & text, const std::vector<std::string> & frames = {"map"}) const
  {
    std::ofstream{path("goals.txt")} << text;
    return LoadGoalsFile(path("goals.txt"), frames);
  }

  /// Without the folder.
  std::string errorOf(const std::string & text, const std::vector<std::string> & frames = {"map"}) const
  {
    try {
      read(text, frames);
    } catch (const GoalsFileError & error) {
      return std::string{error.what()}.substr(folder_.string().size() + 1);
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(GoalsFile, ReadsThreeNumbersAsPositionAndYaw)
{
  const auto goals = read("1 -2.5 1e-1\n");
  ASSERT_EQ(goals.size(), 1u);
  EXPECT_EQ(goals[0].x, 1.0);
  EXPECT_EQ(goals[0].y, -2.5);
  EXPECT_NEAR(goals[0].Yaw(), 0.1, 1e-15);
  EXPECT_EQ(goals[0].frame_id, "map");
}

TEST_F(GoalsFile, ReadsSevenNumbersAsPose)
{
  const auto goals = read("1 2 3 0 0 0.7071 0.7071");
  ASSERT_EQ(goals.size(), 1u);
  EXPECT_EQ(goals[0].z, 3.0);
  EXPECT_EQ(goals[0].qz, 0.7071);
  EXPECT_NEAR(goals[0].Yaw(), M_PI / 2.0, 1e-4);
}

TEST_F(GoalsFile, SkipsCommentsBlankLinesAndCarriageReturns)
{
  const auto goals = read("# goals\r\n\r\n  \t\n1 2 3 # first\r\n#4 5 6\n+7 8 9");
  ASSERT_EQ(goals.size(), 2u);
  EXPECT_EQ(goals[1].x, 7.0);
}

TEST_F(GoalsFile, SkipsAByteOrderMark)
{
  EXPECT_EQ(
    read("\xEF\xBB\xBF"
         "frame_id: map\n1 2 0\n")
      .size(),
    1U);
}

TEST_F(GoalsFile, KeepsTheOrderOfTheFile)
{
  const auto goals = read("3 0 0\n1 0 0\n2 0 0\n");
  EXPECT_EQ(goals[0].x, 3.0);
  EXPECT_EQ(goals[1].x, 1.0);
  EXPECT_EQ(goals[2].x, 2.0);
}

TEST_F(GoalsFile, TakesAKnownFrameFromTheFirstLine)
{
  EXPECT_EQ(read("# c\nframe_id: robot1/odom\n1 2 3", {"map", "robot1/odom"})[0].frame_id, "robot1/odom");
}

TEST_F(GoalsFile, RefusesTooFewNumbers)
{
  EXPECT_EQ(errorOf("1 2 3\n1 2\n"), "goals.txt:2: too few numbers: 2, expected 3 or 7: " + kForms);
}

TEST_F(GoalsFile, RefusesTooManyNumbers)
{
  EXPECT_EQ(errorOf("1 2 3 4 5 6 7 8"), "goals.txt:1: too many numbers: 8, expected 3 or 7: " + kForms);
}

TEST_F(GoalsFile, RefusesACountBetweenTheForms)
{
  EXPECT_EQ(errorOf("1 2 3 4"), "goals.txt:1: wrong count of numbers: 4, expected 3 or 7: " + kForms);
}

TEST_F(GoalsFile, RefusesWhatIsNotANumber)
{
  EXPECT_EQ(errorOf("# c\n\n1 2 north"), "goals.txt:3: yaw is not a number: \"north\"");
  EXPECT_EQ(errorOf("1,5 2 3"), "goals.txt:1: x is not a number: \"1,5\"");
  EXPECT_EQ(errorOf("1 2.0m 3"), "goals.txt:1: y is not a number: \"2.0m\"");
  EXPECT_EQ(errorOf("1 +-2 3"), "goals.txt:1: y is not a number: \"+-2\"");
}

TEST_F(GoalsFile, ShowsWhatIsNoTextByItsBytes)
{
  EXPECT_EQ(errorOf("\xe4 2 3"), "goals.txt:1: x is not a number: \"\\xe4\"");
  EXPECT_EQ(errorOf(std::string("1 2 0\0x", 7)), "goals.txt:1: yaw is not a number: \"0\\x00x\"");
  EXPECT_EQ(errorOf("frame_id: \xc3\xa4\n1 2 3"), "goals.txt:1: unknown frame \"\\xc3\\xa4\", expected one of: map");
}

TEST_F(GoalsFile, RefusesNotFiniteNumbers)
{
  EXPECT_EQ(errorOf("nan 2 3"), "goals.txt:1: x is not finite: nan");
  EXPECT_EQ(errorOf("1 2 -inf"), "goals.txt:1: yaw is not finite: -inf");
  EXPECT_EQ(errorOf("1 1e999 3"), "goals.txt:1: y is out of range: 1e999");
}

TEST_F(GoalsFile, RefusesAQuaternionThatIsNotOne)
{
  EXPECT_EQ(
    errorOf("1 2 0 0 0 0 0"),
    "goals.txt:1: qx qy qz qw is not a unit quaternion: its length is 0, expected 1 within 0.01");
  EXPECT_EQ(
    errorOf("1 2 0 0 0 1 1"),
    "goals.txt:1: qx qy qz qw is not a unit quaternion: its length is 1.41421, expected 1 within 0.01");
}

TEST_F(GoalsFile, RefusesAnUnknownFrame)
{
  EXPECT_EQ(
    errorOf("frame_id: mars\n1 2 3", {"map", "robot1/odom"}),
    "goals.txt:1: unknown frame \"mars\", expected one of: map, robot1/odom");
  EXPECT_EQ(errorOf("frame_id:\n1 2 3"), "goals.txt:1: unknown frame \"\", expected one of: map");
}

TEST_F(GoalsFile, RefusesAFrameThatIsNotFirst)
{
  const std::string expected{"goals.txt:2: frame_id must stand before everything else, and once"};
  EXPECT_EQ(errorOf("1 2 3\nframe_id: map\n"), expected);
  EXPECT_EQ(errorOf("frame_id: map\nframe_id: map\n1 2 3"), expected);
}

TEST_F(GoalsFile, RefusesATextWithoutGoals)
{
  const std::string expected{"goals.txt: no goals in the file; expected lines of " + kForms};
  EXPECT_EQ(errorOf(""), expected);
  EXPECT_EQ(errorOf("# nothing\nframe_id: map\n"), expected);
}

TEST_F(GoalsFile, NamesAFileThatCannotBeRead)
{
  EXPECT_EQ(loadErrorOf(path("no.txt")), path("no.txt") + ": cannot be read: No such file or directory");
  EXPECT_EQ(loadErrorOf(folder_.string()), folder_.string() + ": cannot be read: Is a directory");
}
}  // namespace
