#include "parameter_values.h"

#include <cmath>
#include <istream>
#include <limits>
#include <sstream>

namespace workspace_support
{
namespace
{
using XmlRpc::XmlRpcValue;

/// Whether the next character but blanks is this one, which is then taken.
bool take(std::istream & stream, char expected)
{
  const bool is_next = (stream >> std::ws).peek() == expected;
  if (is_next) {
    stream.get();
  }
  return is_next;
}

std::optional<std::vector<Vec2>> pointsOfText(const std::string & text)
{
  std::istringstream stream(text);
  std::vector<Vec2> points;
  bool is_list = take(stream, '[');
  while (is_list && take(stream, '[')) {
    Vec2 & point = points.emplace_back();
    stream >> point.x;
    take(stream, ',');
    stream >> point.y;
    is_list = take(stream, ']');  // not after something that is not a number
    take(stream, ',');
  }
  is_list = is_list && take(stream, ']') && (stream >> std::ws).eof();
  return is_list ? std::optional(points) : std::nullopt;
}

std::optional<Vec2> toPoint(XmlRpcValue & value)
{
  if (value.getType() != XmlRpcValue::TypeArray || value.size() != 2) {
    return std::nullopt;
  }
  const auto x = toDouble(value[0]);
  const auto y = toDouble(value[1]);
  const bool is_point = x && y && std::isfinite(*x) && std::isfinite(*y);
  return is_point ? std::optional<Vec2>({*x, *y}) : std::nullopt;
}
}  // namespace

std::optional<double> toDouble(XmlRpcValue value)
{
  if (value.getType() == XmlRpcValue::TypeInt) {
    return int(value);
  }
  return value.getType() == XmlRpcValue::TypeDouble ? std::optional<double>(double(value)) : std::nullopt;
}

std::optional<int> toInt(const XmlRpcValue & value)
{
  const auto number = toDouble(value);
  const bool is_whole = number && std::trunc(*number) == *number &&
                        std::abs(*number) <= static_cast<double>(std::numeric_limits<int>::max());
  return is_whole ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
}

std::optional<bool> toBool(XmlRpcValue value)
{
  return value.getType() == XmlRpcValue::TypeBoolean ? std::optional<bool>(bool(value)) : std::nullopt;
}

std::optional<std::string> toString(XmlRpcValue value)
{
  return value.getType() == XmlRpcValue::TypeString ? std::optional<std::string>(std::string(value)) : std::nullopt;
}

std::optional<std::vector<Vec2>> toPoints(XmlRpcValue value)
{
  if (const auto text = toString(value)) {
    return pointsOfText(*text);
  }
  if (value.getType() != XmlRpcValue::TypeArray) {
    return std::nullopt;
  }
  std::vector<Vec2> points;
  for (int i = 0; i < value.size(); ++i) {
    const auto point = toPoint(value[i]);
    if (!point) {
      return std::nullopt;
    }
    points.push_back(*point);
  }
  return points;
}

std::optional<std::vector<PluginName>> toPlugins(XmlRpcValue value)
{
  if (value.getType() != XmlRpcValue::TypeArray) {
    return std::nullopt;
  }
  std::vector<PluginName> plugins;
  for (int i = 0; i < value.size(); ++i) {
    XmlRpcValue & each = value[i];
    if (each.getType() != XmlRpcValue::TypeStruct || !each.hasMember("name") || !each.hasMember("type")) {
      return std::nullopt;
    }
    const auto name = toString(each["name"]);
    const auto type = toString(each["type"]);
    if (!name || !type || name->empty() || type->empty()) {
      return std::nullopt;
    }
    plugins.push_back({*name, *type});
  }
  return plugins;
}

std::string shown(XmlRpcValue value)
{
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      return "\"" + std::string(value) + "\"";
    case XmlRpcValue::TypeBoolean:
      return bool(value) ? "true" : "false";
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
}  // namespace workspace_support
