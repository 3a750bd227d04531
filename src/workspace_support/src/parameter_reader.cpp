#include "workspace_support/parameter_reader.h"

#include <ros/console.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>

#include "parameter_values.h"
#include "workspace_support/errors.h"

namespace workspace_support
{
namespace
{
using XmlRpc::XmlRpcValue;

XmlRpcValue parametersOf(const ros::NodeHandle & node)
{
  XmlRpcValue map;
  node.getParam(node.getNamespace(), map);
  return map;
}

bool isMap(const XmlRpcValue & value)
{
  return value.getType() == XmlRpcValue::TypeStruct;
}
}  // namespace

ParameterReader::ParameterReader(std::string name, const XmlRpcValue & map) : name_(std::move(name)), map_(map)
{
  if (!map_.valid()) {
    map_.begin();  // turns a value that is not set into an empty map
  }
  if (!isMap(map_)) {
    throw OptionError("parameter " + name_ + ": found " + shown(map_) + ", must be a map");
  }
}

ParameterReader::ParameterReader(const ros::NodeHandle & node)
: ParameterReader(node.getNamespace(), parametersOf(node))
{
}

bool ParameterReader::read(const ParameterNames & names, double & value, const NumberRule & rule)
{
  const std::string allowed = rule.range.empty() ? "a finite number" : "a number" + rule.range;
  return readAs(names, allowed, value, [&](const Raw & raw) {
    const auto number = toDouble(raw);
    return number && std::isfinite(*number) && rule.allows(*number) ? number : std::nullopt;
  });
}

bool ParameterReader::read(const ParameterNames & names, int & value, const NumberRule & rule)
{
  return readAs(names, "a whole number" + rule.range, value, [&](const Raw & raw) {
    const auto number = toInt(raw);
    return number && rule.allows(*number) ? number : std::nullopt;
  });
}

bool ParameterReader::read(const ParameterNames & names, bool & value)
{
  return readAs(names, "true or false", value, toBool);
}

bool ParameterReader::read(const ParameterNames & names, std::string & value)
{
  return readAs(names, "a text", value, toString);
}

bool ParameterReader::read(const ParameterNames & names, std::vector<Vec2> & value)
{
  return readAs(names, "a list of points, [[x, y], ...]", value, toPoints);
}

bool ParameterReader::read(const ParameterNames & names, std::vector<PluginName> & value)
{
  return readAs(names, "a list of {name: NAME, type: TYPE}", value, toPlugins);
}

bool ParameterReader::read(const ParameterNames & names, std::optional<double> & value, const NumberRule & rule)
{
  double number = 0.0;
  const bool found = read(names, number, rule);
  if (found) {
    value = number;
  }
  return found;
}

bool ParameterReader::read(const ParameterNames & names, std::vector<std::string> & value)
{
  auto found = find(names);
  if (!found) {
    return false;
  }
  if (found->second.getType() != XmlRpcValue::TypeArray) {
    fail(found->first, "a list of names");
  }
  std::vector<std::string> result;
  for (int i = 0; i < found->second.size(); ++i) {
    const auto name = toString(found->second[i]);
    const std::string place = fullName(found->first) + "[" + std::to_string(i) + "]: found " + shown(found->second[i]);
    if (!name || name->empty()) {
      throw OptionError("parameter " + place + ", must be a name");
    }
    if (std::find(result.begin(), result.end(), *name) != result.end()) {
      throw OptionError("parameter " + place + " twice, must be a different name");
    }
    result.push_back(*name);
  }
  value = result;
  return true;
}

void ParameterReader::readRequired(const std::string & name, std::string & value)
{
  if (!read(name, value) || value.empty()) {
    fail(name, "a text that is not empty");
  }
}

ParameterReader ParameterReader::below(const std::string & name)
{
  const auto found = find(name);
  return {fullName(name), found ? found->second : XmlRpcValue()};
}

std::vector<std::string> ParameterReader::keys() const
{
  std::vector<std::string> names;
  for (const auto & entry : map_) {
    names.push_back(entry.first);
  }
  return names;
}

void ParameterReader::check(const std::function<void()> & validate) const
{
  try {
    validate();
  } catch (const OptionError & error) {
    const std::string text = error.what();
    const std::size_t end = std::min(text.find(':'), text.size());
    throw OptionError("parameter " + fullName(placeOf(text.substr(0, end)) + text.substr(end)));
  }
}

void ParameterReader::fail(const std::string & name, const std::string & allowed) const
{
  const auto found = lookUp(name);
  throw OptionError(
    "parameter " + fullName(name) + ": " + (found ? "found " + shown(*found) : "not set") + ", must be " + allowed);
}

std::optional<std::pair<std::string, XmlRpcValue>> ParameterReader::find(const ParameterNames & names)
{
  note(names);
  for (const std::string & name : names.current) {
    if (const auto value = lookUp(name)) {
      return std::pair(name, *value);
    }
  }
  return std::nullopt;
}

std::optional<XmlRpcValue> ParameterReader::lookUp(const std::string & name) const
{
  Raw value = map_;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string key = name.substr(begin, end - begin);
    if (!isMap(value) || !value.hasMember(key)) {
      return std::nullopt;
    }
    const Raw member = value[key];
    value = member;
    begin = end + 1;
  }
  return value;
}

void ParameterReader::note(const ParameterNames & names)
{
  for (const std::string & name : names.current) {
    if (!isKnown(name)) {
      known_.push_back(name);
    }
  }
}

bool ParameterReader::isKnown(const std::string & name) const
{
  return std::find(known_.begin(), known_.end(), name) != known_.end();
}

// Of several places where a parameter may be, the one where it is.
std::string ParameterReader::placeOf(const std::string & name) const
{
  const auto place = std::find_if(known_.begin(), known_.end(), [&](const std::string & known) {
    return boost::algorithm::ends_with("/" + known, "/" + name) && lookUp(known);
  });
  return place == known_.end() ? name : *place;
}

void ParameterReader::ignore(const std::vector<std::string> & names)
{
  for (const std::string & name : names) {
    note(name);
  }
}

std::vector<std::string> ParameterReader::unused() const
{
  std::vector<std::string> names;
  addUnused("", map_, names);
  return names;
}

void ParameterReader::addUnused(const std::string & prefix, const Raw & map, std::vector<std::string> & names) const
{
  for (const auto & [key, value] : map) {
    const std::string name = prefix + key;
    if (isKnown(name)) {
      continue;
    }
    if (isMap(value)) {
      addUnused(name + "/", value, names);
    } else {
      names.push_back(name);
    }
  }
}

void ParameterReader::refuseUnused() const
{
  const auto names = unused();
  if (names.empty()) {
    return;
  }
  const std::string & name = names.front();
  const std::string place = name.substr(0, name.rfind('/') + 1);
  std::vector<std::string> allowed;
  for (const std::string & known : known_) {
    if (boost::algorithm::starts_with(known, place)) {
      allowed.push_back(known.substr(place.size()));
    }
  }
  throw OptionError(
    "parameter " + fullName(name) +
    ": unknown; allowed: " + boost::algorithm::join(allowed.empty() ? known_ : allowed, ", "));
}

void ParameterReader::warnOfUnused(const std::vector<std::string> & important) const
{
  std::vector<std::string> rest;
  for (const std::string & name : unused()) {
    const auto begins = [&](const std::string & beginning) { return boost::algorithm::starts_with(name, beginning); };
    if (std::any_of(important.begin(), important.end(), begins)) {
      ROS_WARN("No use is made of parameter %s", fullName(name).c_str());
    } else {
      rest.push_back(name);
    }
  }
  if (!rest.empty()) {
    ROS_WARN("No use is made of these parameters in %s: %s", name_.c_str(), boost::algorithm::join(rest, ", ").c_str());
  }
}
}  // namespace workspace_support
