#pragma once

#include <console_bridge/console.h>

#include <memory>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// While it lives, what libsdformat and urdfdom would print on the terminal is kept here instead.
/// Both have one console a process, so one at a time: a second one waits.
class SdfMessages
{
public:
  SdfMessages();
  ~SdfMessages();
  SdfMessages(const SdfMessages &) = delete;
  SdfMessages & operator=(const SdfMessages &) = delete;

  /// One line each, without colours and without places in libsdformat's own source.
  std::vector<std::string> errors() const;
  std::vector<std::string> warnings() const;

private:
  class UrdfMessages : public console_bridge::OutputHandler
  {
  public:
    void log(const std::string & text, console_bridge::LogLevel level, const char *, int) override;
    std::vector<std::string> errors;
    std::vector<std::string> warnings;
  };

  std::lock_guard<std::mutex> only_one_;
  std::ostringstream sdf_text_;
  std::ostream * sdf_stream_before_;
  UrdfMessages urdf_messages_;
};
}  // namespace f1tenth_sim2d
