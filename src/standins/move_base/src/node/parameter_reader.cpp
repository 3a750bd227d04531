#include "parameter_reader.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "move_base/errors.h"

namespace move_base
{
namespace
{
using XmlRpc::XmlRpcValue;

std::optional<double> toDouble(XmlRpcValue & value)
{
  if (value.getType() == XmlRpcValue::TypeDouble) {
    return static_cast<double>(value);
  }
  if (value.getType() == XmlRpcValue::TypeInt) {
    return static_cast<int>(value);
  }
  return std::nullopt;
}

std::optional<int> toInt(XmlRpcValue & value)
{
  return value.getType() == XmlRpcValue::TypeInt ? std::optional<int>(static_cast<int>(value)) : std::nullopt;
}

std::optional<bool> toBool(XmlRpcValue & value)
{
  return value.getType() == XmlRpcValue::TypeBoolean ? std::optional<bool>(static_cast<bool>(value)) : std::nullopt;
}

std::optional<std::string> toText(XmlRpcValue & value)
{
  return value.getType() == XmlRpcValue::TypeString ? std::optional<std::string>(static_cast<std::string>(value))
                                                    : std::nullopt;
}

std::optional<std::vector<Vec2>> pointsOfText(std::string text)
{
  const auto isBracket = [](char c) { return c == '[' || c == ']' || c == ','; };
  std::replace_if(text.begin(), text.end(), isBracket, ' ');
  std::istringstream stream(text);
  std::vector<Vec2> points;
  for (Vec2 point; stream >> point.x >> point.y;) {
    points.push_back(point);
  }
  stream.clear();
  std::string rest;
  return stream >> rest ? std::nullopt : std::optional<std::vector<Vec2>>(points);
}

std::optional<std::vector<Vec2>> toPoints(XmlRpcValue & value)
{
  if (value.getType() == XmlRpcValue::TypeString) {
    return pointsOfText(static_cast<std::string>(value));
  }
  if (value.getType() != XmlRpcValue::TypeArray) {
    return std::nullopt;
  }
  std::vector<Vec2> points;
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() != XmlRpcValue::TypeArray || value[i].size() != 2) {
      return std::nullopt;
    }
    const auto x = toDouble(value[i][0]);
    const auto y = toDouble(value[i][1]);
    if (!x || !y) {
      return std::nullopt;
    }
    points.push_back({*x, *y});
  }
  return points;
}
}  // namespace

template <class Value, class Convert>
bool ParameterReader::readAs(
  const std::vector<std::string> & names, const std::string & allowed, Value & value, Convert convert)
{
  known_.insert(names.begin(), names.end());
  for (const std::string & name : names) {
    XmlRpcValue raw;
    if (!node_.getParam(name, raw)) {
      continue;
    }
    const auto converted = convert(raw);
    if (!converted) {
      throw OptionError(node_.resolveName(name) + ": found " + raw.toXml() + ", must be " + allowed);
    }
    value = *converted;
    return true;
  }
  return false;
}

bool ParameterReader::read(const std::vector<std::string> & names, double & value)
{
  return readAs(names, "a number", value, toDouble);
}

bool ParameterReader::read(const std::vector<std::string> & names, int & value)
{
  return readAs(names, "an integer", value, toInt);
}

bool ParameterReader::read(const std::vector<std::string> & names, bool & value)
{
  return readAs(names, "true or false", value, toBool);
}

bool ParameterReader::read(const std::vector<std::string> & names, std::string & value)
{
  return readAs(names, "a string", value, toText);
}

bool ParameterReader::read(const std::vector<std::string> & names, std::vector<Vec2> & value)
{
  return readAs(names, "a list of points, [[x, y], ...]", value, toPoints);
}

std::vector<std::string> ParameterReader::unused() const
{
  const std::string prefix = node_.getNamespace() + "/";
  std::vector<std::string> all;
  node_.getParamNames(all);
  std::vector<std::string> names;
  for (const std::string & name : all) {
    const bool own = name.compare(0, prefix.size(), prefix) == 0;
    if (own && known_.count(name.substr(prefix.size())) == 0) {
      names.push_back(name.substr(prefix.size()));
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}
}  // namespace move_base
