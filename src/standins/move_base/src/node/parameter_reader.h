#pragma once

#include <ros/node_handle.h>

#include <set>
#include <string>
#include <vector>

#include "move_base/geometry.h"

namespace move_base
{
/// Reads parameters of a node and notes which there were, to tell which have no use.
class ParameterReader
{
public:
  /// @param node  whose namespace the parameters are in
  explicit ParameterReader(const ros::NodeHandle & node) : node_(node) {}

  /// Sets value from the first of names that is a parameter, else leaves it. @return whether there was one
  /// @throws OptionError for a parameter of another type
  bool read(const std::vector<std::string> & names, double & value);
  bool read(const std::vector<std::string> & names, int & value);
  bool read(const std::vector<std::string> & names, bool & value);
  bool read(const std::vector<std::string> & names, std::string & value);
  /// A list of points, [[x, y], ...], also as a string.
  bool read(const std::vector<std::string> & names, std::vector<Vec2> & value);

  /// Parameters in the node's namespace that nobody has asked for, without the namespace.
  std::vector<std::string> unused() const;

private:
  template <class Value, class Convert>
  bool readAs(const std::vector<std::string> & names, const std::string & allowed, Value & value, Convert convert);

  ros::NodeHandle node_;
  std::set<std::string> known_;
};
}  // namespace move_base
