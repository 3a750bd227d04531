#include "odometry_parameters.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <functional>
#include <locale>
#include <map>
#include <set>
#include <sstream>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_gazebo_plugins
{
namespace
{
using ros::console::levels::Level;

/// One tag of the element, for reading and for refusing it.
struct Tag
{
  const std::string & place;
  std::string name;
  std::string text;

  [[noreturn]] void refuse(const std::string & expected) const
  {
    throw f1tenth_sim2d::Error(place + ": <" + name + ">: found \"" + text + "\", expected " + expected);
  }

  bool flag() const
  {
    const std::string value = boost::algorithm::to_lower_copy(text);
    if (value == "true" || value == "1") {
      return true;
    }
    if (value == "false" || value == "0") {
      return false;
    }
    refuse("true or false");
  }

  double rate(double max_rate_hz) const
  {
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    double value = 0.0;
    if (
      !(stream >> value) || !(stream >> std::ws).eof() || !std::isfinite(value) || value <= 0.0 ||
      value > max_rate_hz * (1.0 + 1e-9)) {
      refuse(
        "a number of Hz > 0 and at most " + f1tenth_sim2d::toText(max_rate_hz) + ", the rate of the physics steps");
    }
    return value;
  }

  std::string word() const
  {
    if (text.empty() || text.find_first_of(" \t\r\n") != std::string::npos) {
      refuse("a name without spaces");
    }
    return text;
  }

  void requireBase(const std::vector<std::string> & links, const std::string & base_frame) const
  {
    if (std::find(links.begin(), links.end(), text) == links.end()) {
      refuse("a link of the robot description: " + boost::algorithm::join(links, ", "));
    }
    if (text != base_frame) {
      refuse(
        base_frame +
        ", the link that stands for the car: every other one gets its transform from the robot description");
    }
  }

  std::optional<Level> logLevel() const
  {
    static const std::map<std::string, std::optional<Level>> kLevels{
      {"debug", ros::console::levels::Debug}, {"info", ros::console::levels::Info},
      {"warn", ros::console::levels::Warn},   {"error", ros::console::levels::Error},
      {"fatal", ros::console::levels::Fatal}, {"na", std::nullopt}};
    const auto level = kLevels.find(boost::algorithm::to_lower_copy(text));
    if (level == kLevels.end()) {
      refuse("one of Debug, Info, Warn, Error, Fatal, na");
    }
    return level->second;
  }
};

using Readers = std::vector<std::pair<std::string, std::function<void(const Tag &)>>>;

const std::function<void(const Tag &)> & readerOf(const Readers & readers, const Tag & tag)
{
  std::vector<std::string> allowed;
  for (const auto & [name, reader] : readers) {
    if (name == tag.name) {
      return reader;
    }
    allowed.push_back(name);
  }
  throw f1tenth_sim2d::Error(
    tag.place + ": <" + tag.name + ">: unknown; allowed: " + boost::algorithm::join(allowed, ", "));
}
}  // namespace

OdometryParameters parseOdometryParameters(
  const f1tenth_sim2d::PluginElement & element, const std::vector<std::string> & links, const std::string & base_frame,
  double max_rate_hz)
{
  OdometryParameters parameters;
  const Readers readers{
    {"alwaysOn", [&](const Tag & tag) { parameters.always_on = tag.flag(); }},
    {"updateRate", [&](const Tag & tag) { parameters.update_rate_hz = tag.rate(max_rate_hz); }},
    {"odometryTopic", [&](const Tag & tag) { parameters.topic = tag.word(); }},
    {"poseTopic", [&](const Tag & tag) { parameters.pose_topic = tag.word(); }},
    {"odometryFrame", [&](const Tag & tag) { parameters.odometry_frame = tag.word(); }},
    {"robotBaseFrame", [&](const Tag & tag) { tag.requireBase(links, base_frame); }},
    {"rosDebugLevel", [&](const Tag & tag) { parameters.log_level = tag.logLevel(); }},
  };
  std::set<std::string> seen;
  for (const auto & [name, text] : element.parameters) {
    const Tag tag{element.place, name, boost::algorithm::trim_copy(text)};
    const auto & read = readerOf(readers, tag);
    if (!seen.insert(name).second) {
      throw f1tenth_sim2d::Error(element.place + ": <" + name + ">: found twice, expected once");
    }
    read(tag);
  }
  return parameters;
}
}  // namespace f1tenth_gazebo_plugins
