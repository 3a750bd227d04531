#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>

#include "read_goals.h"

namespace f1tenth_navigation_mgr
{
namespace
{
/// The fewest digits that read back as the same number.
std::string shortest(double number)
{
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), result.ptr};
}

void writeLine(std::ostream & text, std::initializer_list<double> numbers)
{
  const char * separator = "";
  for (const double number : numbers) {
    text << separator << shortest(number);
    separator = " ";
  }
  text << '\n';
}

void writeGoal(std::ostream & text, const Goal & goal)
{
  // The short form only if it loses nothing.
  if (PlanarGoal(goal.x, goal.y, goal.Yaw(), goal.frame_id) == goal) {
    writeLine(text, {goal.x, goal.y, goal.Yaw()});
  } else {
    writeLine(text, {goal.x, goal.y, goal.z, goal.qx, goal.qy, goal.qz, goal.qw});
  }
}

[[noreturn]] void failWriting(const std::string & path, const std::string & temporary)
{
  const std::string reason{std::strerror(errno)};
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw GoalsFileError{path + ": cannot be written: " + reason};
}

void expectOneFrame(const std::string & path, const Goals & goals)
{
  if (goals.empty()) throw GoalsFileError{path + ": no goals to save"};
  for (const auto & goal : goals) {
    if (goal.frame_id == goals.front().frame_id) continue;
    throw GoalsFileError{
      path + ": a goals file has one frame, found \"" + goals.front().frame_id + "\" and \"" + goal.frame_id + "\""};
  }
}

/// Numbers and frames that no goals file can hold are reported as when a file is read.
std::string textOf(const std::string & path, const Goals & goals)
{
  std::stringstream text;
  text << "frame_id: " << goals.front().frame_id << '\n';
  for (const auto & goal : goals) writeGoal(text, goal);
  const std::string written{text.str()};
  readGoals(text, path, {goals.front().frame_id});
  return written;
}

/// The file that a link leads to: the link stays one.
std::filesystem::path fileBehind(const std::string & path)
{
  std::error_code ignored;
  const auto file = std::filesystem::canonical(path, ignored);
  return file.empty() ? std::filesystem::path{path} : file;
}
}  // namespace

void SaveGoalsFile(const std::string & path, const Goals & goals)
{
  expectOneFrame(path, goals);
  const std::string text{textOf(path, goals)};
  const auto file = fileBehind(path);
  if (std::filesystem::is_other(file)) throw GoalsFileError{path + ": cannot be written: not a regular file"};
  const std::string temporary{file.string() + ".tmp"};
  errno = 0;
  std::ofstream stream{temporary, std::ios::trunc};
  stream << text;
  stream.close();
  if (!stream || std::rename(temporary.c_str(), file.c_str()) != 0) failWriting(path, temporary);
}
}  // namespace f1tenth_navigation_mgr
