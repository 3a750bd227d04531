#include "node/app/run_result.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "f1tenth_sim2d/errors.h"

using f1tenth_sim2d::writeResult;

namespace
{
class RunResultTest : public testing::Test
{
public:
  RunResultTest()
  {
    std::string name = (std::filesystem::temp_directory_path() / "run_result_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~RunResultTest() override { std::filesystem::remove_all(folder_); }

protected:
  std::filesystem::path folder_;
};
}  // namespace

TEST_F(RunResultTest, WritesAllFieldsAndLeavesNoTemporaryFile)
{
  const std::string file = folder_ / "result.json";
  writeResult(
    file, {"participant_silent",
           "a \"quoted\" line",
           "robot1",
           1.5,
           0.25,
           60,
           {{"robot1", 40, 1.0}},
           "abc",
           7,
           0.001,
           "def",
           {{"robot1", "0a"}}});
  const auto json = nlohmann::json::parse(std::ifstream(file));
  EXPECT_EQ(json.size(), 12u);
  EXPECT_EQ(json["reason"], "participant_silent");
  EXPECT_EQ(json["error"], "a \"quoted\" line");
  EXPECT_EQ(json["participant"], "robot1");
  EXPECT_EQ(json["sim_time"], 1.5);
  EXPECT_EQ(json["wall_time"], 0.25);
  EXPECT_EQ(json["periods"], 60);
  EXPECT_EQ(json["trajectory_hash"], "abc");
  EXPECT_EQ(json["stray_answers"].dump(), R"([{"participant":"robot1","period":40,"time":1.0}])");
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["physics_step"], 0.001);
  EXPECT_EQ(json["world_sha256"], "def");
  EXPECT_EQ(json["cars_sha256"]["robot1"], "0a");
  EXPECT_FALSE(std::filesystem::exists(file + ".tmp"));
}

TEST_F(RunResultTest, NamesTheFileThatCannotBeWritten)
{
  const std::string file = folder_ / "missing" / "result.json";
  try {
    writeResult(file, {});
    FAIL() << "no error";
  } catch (const f1tenth_sim2d::Error & error) {
    EXPECT_EQ(std::string(error.what()), "result_file: cannot write " + file + ".tmp: No such file or directory");
  }
}
