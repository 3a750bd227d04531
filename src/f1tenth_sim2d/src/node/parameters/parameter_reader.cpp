#include "node/parameters/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
using XmlRpc::XmlRpcValue;

std::string shown(const XmlRpcValue & value)
{
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      return "\"" + std::string(XmlRpcValue(value)) + "\"";
    case XmlRpcValue::TypeBoolean:
      return bool(XmlRpcValue(value)) ? "true" : "false";
    case XmlRpcValue::TypeStruct:
      return "a map";
    case XmlRpcValue::TypeArray:
      return "a list";
    default: {
      std::ostringstream text;
      value.write(text);
      return text.str();
    }
  }
}
}  // namespace

ParameterReader::ParameterReader(std::string name, XmlRpcValue value, const std::vector<std::string> & allowed)
: name_(std::move(name)), value_(std::move(value))
{
  if (!value_.valid()) {
    value_.begin();  // turns a value that is not set into an empty map
  }
  if (value_.getType() != XmlRpcValue::TypeStruct) {
    throw Error("parameter " + name_ + ": found " + shown(value_) + ", expected a map");
  }
  for (const auto & entry : value_) {
    if (std::find(allowed.begin(), allowed.end(), entry.first) == allowed.end()) {
      throw Error("parameter " + fullName(entry.first) + ": unknown; allowed: " + joined(allowed));
    }
  }
}

bool ParameterReader::has(const std::string & key) const
{
  return value_.hasMember(key);
}

void ParameterReader::fail(const std::string & key, const std::string & expected) const
{
  const std::string found = has(key) ? "found " + shown(XmlRpcValue(value_)[key]) : "not set";
  throw Error("parameter " + fullName(key) + ": " + found + ", expected " + expected);
}

double ParameterReader::number(const std::string & key, double fallback, const NumberRule & rule)
{
  double result = fallback;
  if (has(key)) {
    XmlRpcValue & value = value_[key];
    if (value.getType() == XmlRpcValue::TypeInt) {
      result = int(value);
    } else if (value.getType() == XmlRpcValue::TypeDouble) {
      result = double(value);
    } else {
      fail(key, rule.expected);
    }
  }
  if (!std::isfinite(result) || !rule.allows(result)) {
    fail(key, rule.expected);
  }
  return result;
}

int ParameterReader::natural(const std::string & key, int fallback)
{
  if (!has(key)) {
    return fallback;
  }
  XmlRpcValue & value = value_[key];
  if (value.getType() != XmlRpcValue::TypeInt || int(value) < 0) {
    fail(key, "a whole number >= 0");
  }
  return value;
}

bool ParameterReader::flag(const std::string & key, bool fallback)
{
  if (!has(key)) {
    return fallback;
  }
  if (value_[key].getType() != XmlRpcValue::TypeBoolean) {
    fail(key, "true or false");
  }
  return value_[key];
}

std::string ParameterReader::text(const std::string & key, const std::string & fallback)
{
  if (!has(key)) {
    return fallback;
  }
  if (value_[key].getType() != XmlRpcValue::TypeString) {
    fail(key, "a text");
  }
  return value_[key];
}

std::string ParameterReader::requiredText(const std::string & key)
{
  const std::string result = text(key, "");
  if (result.empty()) {
    fail(key, "a text that is not empty");
  }
  return result;
}

std::string ParameterReader::choice(
  const std::string & key, const std::string & fallback, const std::vector<std::string> & choices)
{
  const std::string result = text(key, fallback);
  if (std::find(choices.begin(), choices.end(), result) == choices.end()) {
    fail(key, "one of " + joined(choices));
  }
  return result;
}

std::vector<std::string> ParameterReader::names(const std::string & key)
{
  std::vector<std::string> result;
  if (!has(key)) {
    return result;
  }
  XmlRpcValue & list = value_[key];
  if (list.getType() != XmlRpcValue::TypeArray) {
    fail(key, "a list of names");
  }
  for (int i = 0; i < list.size(); ++i) {
    const std::string place = key + "[" + std::to_string(i) + "]";
    if (list[i].getType() != XmlRpcValue::TypeString || std::string(list[i]).empty()) {
      throw Error("parameter " + fullName(place) + ": found " + shown(list[i]) + ", expected a name");
    }
    const std::string name = list[i];
    if (std::find(result.begin(), result.end(), name) != result.end()) {
      throw Error("parameter " + fullName(place) + ": found " + shown(list[i]) + " twice, expected different names");
    }
    result.push_back(name);
  }
  return result;
}

XmlRpcValue ParameterReader::optionalMap(const std::string & key)
{
  if (!has(key)) {
    XmlRpcValue empty;
    empty.begin();
    return empty;
  }
  if (value_[key].getType() != XmlRpcValue::TypeStruct) {
    fail(key, "a map");
  }
  return value_[key];
}

std::string joined(const std::vector<std::string> & words)
{
  std::string result;
  for (const auto & word : words) {
    result += (result.empty() ? "" : ", ") + word;
  }
  return result;
}
}  // namespace f1tenth_sim2d
