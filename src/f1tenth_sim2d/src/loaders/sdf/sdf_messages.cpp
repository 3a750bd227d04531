#include "loaders/sdf/sdf_messages.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <regex>
#include <sdf/Console.hh>

namespace f1tenth_sim2d
{
namespace
{
std::mutex & consoleMutex()
{
  static std::mutex mutex;
  return mutex;
}

/// libsdformat opens $HOME/.sdformat/sdformat.log when its console comes to be, and has no switch against it.
/// A simulation leaves nothing in people's homes, so at that moment home is where no folder can be made.
void createConsoleWithoutLogFile()
{
  const char * const value = std::getenv("HOME");
  const std::optional<std::string> home = value ? std::optional<std::string>(value) : std::nullopt;
  setenv("HOME", "/dev/null", 1);
  sdf::Console::Instance();
  if (home) {
    setenv("HOME", home->c_str(), 1);
  } else {
    unsetenv("HOME");
  }
}

/// Words with one blank between them.
std::string inOneLine(const std::string & text)
{
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

/// The lines of libsdformat's console that start with the label "Error" or "Warning"; further lines belong to them.
std::vector<std::string> linesLabelled(const std::string & label, const std::string & text)
{
  static const std::regex head(R"(\x1b\[1;\d+m(\w+) \[[^\]]{0,200}\]\x1b\[0m )");
  std::vector<std::string> lines;
  for (std::sregex_iterator match(text.begin(), text.end(), head), end; match != end; ++match) {
    if ((*match)[1] != label) {
      continue;
    }
    const auto next = std::next(match);
    const auto stop = next == end ? text.end() : next->operator[](0).first;
    lines.push_back(inOneLine(std::string((*match)[0].second, stop)));
  }
  return lines;
}

/// Said of every document that is not URDF, and of every file that is not found: more is known elsewhere.
bool saysNothing(const std::string & line)
{
  return line.find("Could not find the 'robot' element") != std::string::npos ||
         line.find("Tried to use callback in sdf::findFile()") != std::string::npos;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string> & second)
{
  first.insert(first.end(), second.begin(), second.end());
  first.erase(std::remove_if(first.begin(), first.end(), saysNothing), first.end());
  return first;
}
}  // namespace

SdfMessages::SdfMessages() : only_one_(consoleMutex())
{
  static std::once_flag console_created;
  std::call_once(console_created, createConsoleWithoutLogFile);
  auto & stream = sdf::Console::Instance()->GetMsgStream();
  sdf_stream_before_ = stream.GetStream();
  stream.SetStream(&sdf_text_);
  console_bridge::useOutputHandler(&urdf_messages_);
}

SdfMessages::~SdfMessages()
{
  console_bridge::restorePreviousOutputHandler();
  sdf::Console::Instance()->GetMsgStream().SetStream(sdf_stream_before_);
}

void SdfMessages::UrdfMessages::log(const std::string & text, console_bridge::LogLevel level, const char *, int)
{
  if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
    errors.push_back(text);
  } else if (level == console_bridge::CONSOLE_BRIDGE_LOG_WARN) {
    warnings.push_back(text);
  }
}

std::vector<std::string> SdfMessages::errors() const
{
  return joined(linesLabelled("Error", sdf_text_.str()), urdf_messages_.errors);
}

std::vector<std::string> SdfMessages::warnings() const
{
  return joined(linesLabelled("Warning", sdf_text_.str()), urdf_messages_.warnings);
}
}  // namespace f1tenth_sim2d
