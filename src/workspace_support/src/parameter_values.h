#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <optional>
#include <string>
#include <vector>

#include "workspace_support/parameter_reader.h"
#include "workspace_support/planar.h"

/// From values of the parameter server; nothing for one of another type.
namespace workspace_support
{
std::optional<double> toDouble(XmlRpc::XmlRpcValue value);
/// Also a number with a point, if it is whole.
std::optional<int> toInt(const XmlRpc::XmlRpcValue & value);
std::optional<bool> toBool(XmlRpc::XmlRpcValue value);
std::optional<std::string> toString(XmlRpc::XmlRpcValue value);
/// [[x, y], ...], finite; also as a text.
std::optional<std::vector<Vec2>> toPoints(XmlRpc::XmlRpcValue value);
/// [{name: NAME, type: TYPE}, ...], each text not empty; other members are ignored.
std::optional<std::vector<PluginName>> toPlugins(XmlRpc::XmlRpcValue value);

/// A value as error messages show it.
std::string shown(XmlRpc::XmlRpcValue value);
}  // namespace workspace_support
