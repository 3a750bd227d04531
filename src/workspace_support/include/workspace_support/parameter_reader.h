#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <boost/algorithm/string/join.hpp>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workspace_support/number_rule.h"
#include "workspace_support/parameter_names.h"
#include "workspace_support/planar.h"

namespace workspace_support
{
/// A plugin in a list of them.
struct PluginName
{
  std::string name;
  std::string type;  ///< "package/Class" or "package::Class"
};

/// Reads a map of parameters once, and notes which were asked for, to tell which are unused.
///
/// Each read() sets the value if there is such a parameter, else leaves it, and returns whether there is one. Whatever
/// cannot be used is an OptionError: "parameter FULL NAME: found X, must be Y".
class ParameterReader
{
public:
  /// Needs no ROS master.
  /// @param name  full name of the map ("/sim2d"), the start of every error message
  /// @param map   not set: no parameters
  ParameterReader(std::string name, const XmlRpc::XmlRpcValue & map);
  /// All parameters in the namespace of a node.
  explicit ParameterReader(const ros::NodeHandle & node);

  bool read(const ParameterNames & names, double & value, const NumberRule & rule = {});
  /// A whole number; also one written as 5.0.
  bool read(const ParameterNames & names, int & value, const NumberRule & rule = {});
  bool read(const ParameterNames & names, bool & value);
  bool read(const ParameterNames & names, std::string & value);
  /// Distinct texts that are not empty.
  bool read(const ParameterNames & names, std::vector<std::string> & value);
  /// A list of points, [[x, y], ...], finite; also as a text, in which blanks may stand for commas.
  bool read(const ParameterNames & names, std::vector<Vec2> & value);
  /// A list of mappings with the texts name and type.
  bool read(const ParameterNames & names, std::vector<PluginName> & value);
  bool read(const ParameterNames & names, std::optional<double> & value, const NumberRule & rule = {});
  /// One of several words, each with its value.
  template <class Value>
  bool readChoice(
    const ParameterNames & names, Value & value, const std::vector<std::pair<std::string, Value>> & choices);
  /// A text that must be there and must not be empty.
  void readRequired(const std::string & name, std::string & value);

  /// A map below this one, to be read and checked by itself; empty if it is not there.
  ParameterReader below(const std::string & name);
  /// Keys of this map, in alphabetical order.
  std::vector<std::string> keys() const;
  std::string fullName(const std::string & name) const { return name_ + "/" + name; }

  /// Calls a check that throws OptionError ("NAME: found X, must be Y"), and puts in the place of NAME the full name under
  /// which it was read.
  void check(const std::function<void()> & validate) const;
  /// @param allowed  "a text"
  [[noreturn]] void fail(const std::string & name, const std::string & allowed) const;

  /// Counts parameters that are meant for others as asked for.
  void ignore(const std::vector<std::string> & names);
  /// Parameters that nobody has asked for, without the name of this map.
  std::vector<std::string> unused() const;
  /// Throws for the first of these, and names those that are known beside it.
  void refuseUnused() const;
  /// Names these in one warning, if there are any.
  /// @param important  prefixes of names that get a warning each, "TebLocalPlannerROS/"
  void warnOfUnused(const std::vector<std::string> & important = {}) const;

private:
  using Raw = XmlRpc::XmlRpcValue;
  std::optional<std::pair<std::string, Raw>> find(const ParameterNames & names);
  std::optional<Raw> lookUp(const std::string & name) const;
  void note(const ParameterNames & names);
  bool isKnown(const std::string & name) const;
  std::string placeOf(const std::string & name) const;
  void addUnused(const std::string & prefix, const Raw & map, std::vector<std::string> & names) const;
  template <class Value, class Convert>
  bool readAs(const ParameterNames & names, const std::string & allowed, Value & value, const Convert & convert);

  const std::string name_;
  Raw map_;
  std::vector<std::string> known_;  // in the order in which they were asked for
};

template <class Value>
bool ParameterReader::readChoice(
  const ParameterNames & names, Value & value, const std::vector<std::pair<std::string, Value>> & choices)
{
  std::vector<std::string> words;
  words.reserve(choices.size());
  for (const auto & choice : choices) {
    words.push_back(choice.first);
  }
  const auto convert = [&](const Raw & raw) -> std::optional<Value> {
    for (const auto & [word, meaning] : choices) {
      if (raw == Raw(word)) {
        return meaning;
      }
    }
    return std::nullopt;
  };
  return readAs(names, "one of " + boost::algorithm::join(words, ", "), value, convert);
}

template <class Value, class Convert>
bool ParameterReader::readAs(
  const ParameterNames & names, const std::string & allowed, Value & value, const Convert & convert)
{
  const auto found = find(names);
  if (!found) {
    return false;
  }
  const std::optional<Value> converted = convert(found->second);
  if (!converted) {
    fail(found->first, allowed);
  }
  value = *converted;
  return true;
}
}  // namespace workspace_support
