#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace workspace_support
{
/// Reads parameters of a node and notes which it was asked for, to tell which have no use.
class ParameterReader
{
public:
  /// @param node  whose namespace the parameters are in
  explicit ParameterReader(const ros::NodeHandle & node) : node_(node) {}

  /// Sets value if there is such a parameter, else leaves it.
  /// @throws OptionError for a parameter of another type
  template <class Value>
  void read(const std::string & name, Value & value);

  template <class Value>
  void read(const std::string & name, std::optional<Value> & value);

  /// Parameters in the node's namespace that nobody has asked for, without the namespace.
  std::vector<std::string> unused() const;
  /// Says these once, if there are any.
  void warnOfUnused() const;

private:
  ros::NodeHandle node_;
  std::set<std::string> known_;
};
}  // namespace workspace_support
