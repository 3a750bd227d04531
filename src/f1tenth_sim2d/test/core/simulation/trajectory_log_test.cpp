#include "core/simulation/trajectory_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/algorithm/string.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "sample_world.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr SimTime kPeriod = 25'000'000;  // ns

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields(const std::string & line)
{
  std::vector<std::string> result;
  return boost::algorithm::split(result, line, boost::algorithm::is_any_of(","));
}

std::vector<Row> rows(const std::filesystem::path & file)
{
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const auto header = fields(line);
  std::vector<Row> result;
  while (std::getline(stream, line)) {
    const auto values = fields(line);
    Row row;
    for (std::size_t i = 0; i < header.size(); ++i) {
      row[header[i]] = values.at(i);
    }
    result.push_back(row);
  }
  return result;
}

Contact contactWith(const std::string & model, double speed)
{
  Contact contact;
  contact.other_model = model;
  contact.speed = speed;
  return contact;
}

class TrajectoryLogTest : public ::testing::Test
{
protected:
  TrajectoryLogTest()
  {
    std::filesystem::create_directories(folder_);
    simulation_.addCar(test::car("robot1"), {}, {});
    simulation_.addCar(test::car("robot2"), {}, {3.0, 0.0, 0.0});
  }
  ~TrajectoryLogTest() override { std::filesystem::remove_all(folder_); }

  void passPeriod(TrajectoryLog & log)
  {
    simulation_.advanceTo(simulation_.time() + kPeriod);
    log.endPeriod();
  }

  const std::filesystem::path folder_ =
    std::filesystem::temp_directory_path() / ("trajectory_log_test_" + std::to_string(getpid()));
  const std::filesystem::path file_ = folder_ / "record.csv";
  Simulation simulation_{test::world({test::wallAcross(5.0)})};
};

TEST_F(TrajectoryLogTest, TouchStandsInItsPeriodOnlyAndWithItsCarOnly)
{
  TrajectoryLog log(simulation_, file_.string());
  passPeriod(log);
  log.note(test::kRobot1, contactWith("walls", 0.5));
  log.note(test::kRobot1, contactWith("crate", 1.5));
  log.note(test::kRobot1, contactWith("walls", 1.0));
  passPeriod(log);
  passPeriod(log);
  const auto found = rows(file_);
  ASSERT_EQ(found.size(), 6U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool touched = i == 2;  // robot1 in the second period
    EXPECT_EQ(found[i].at("contacts"), touched ? "crate;walls" : "") << i;
    EXPECT_EQ(std::stod(found[i].at("contact_speed")), touched ? 1.5 : 0.0) << i;
    EXPECT_EQ(found[i].at("car"), i % 2 == 0 ? "robot1" : "robot2") << i;
  }
}

TEST_F(TrajectoryLogTest, RestartKeepsWhatWasAndTheTouchOfTheUnfinishedPeriod)
{
  TrajectoryLog log(simulation_, file_.string());
  passPeriod(log);
  simulation_.advanceTo(simulation_.time() + kPeriod / 5);
  log.note(test::kRobot2, contactWith("walls", 2.0));
  log.restart();
  simulation_.reset();
  passPeriod(log);
  log.restart();
  simulation_.reset();
  const auto first = rows(folder_ / "record.csv.before_reset_1");
  ASSERT_EQ(first.size(), 4U);
  EXPECT_EQ(first[3].at("contacts"), "walls");
  EXPECT_EQ(first[3].at("time"), "0.030000000");
  EXPECT_EQ(rows(folder_ / "record.csv.before_reset_2").size(), 2U);
  EXPECT_TRUE(rows(file_).empty());
}

TEST_F(TrajectoryLogTest, RunAfterARestartHasTheHashOfAFreshOne)
{
  TrajectoryLog log(simulation_, "");
  passPeriod(log);
  const std::string hash = log.hash();
  passPeriod(log);
  ASSERT_NE(log.hash(), hash);
  log.restart();
  simulation_.reset();
  passPeriod(log);
  EXPECT_EQ(log.hash(), hash);
}

TEST_F(TrajectoryLogTest, FileThatCannotBeWrittenIsAnErrorThatNamesIt)
{
  try {
    const TrajectoryLog log(simulation_, "/nowhere/record.csv");
    FAIL() << "written";
  } catch (const Error & error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/record.csv"), std::string::npos) << error.what();
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
