#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <functional>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// What a number must be besides finite.
struct NumberRule
{
  std::function<bool(double)> allows;
  std::string expected;  ///< as error messages say it, "a number > 0"
};

/// Reads one map of parameters, each key once, with errors that say the full name, what was found and what is allowed.
/// Every method throws Error. Needs no ROS master.
class ParameterReader
{
public:
  /// @param name    full name of the map ("/sim2d"), the start of every error message
  /// @param allowed all keys that may be there
  ParameterReader(std::string name, XmlRpc::XmlRpcValue value, const std::vector<std::string> & allowed);

  bool has(const std::string & key) const;
  double number(const std::string & key, double fallback, const NumberRule & rule);
  /// A whole number from 0.
  int natural(const std::string & key, int fallback);
  bool flag(const std::string & key, bool fallback);
  std::string text(const std::string & key, const std::string & fallback);
  std::string requiredText(const std::string & key);
  std::string choice(const std::string & key, const std::string & fallback, const std::vector<std::string> & choices);
  /// Different, not empty texts.
  std::vector<std::string> names(const std::string & key);
  /// The map below key, to be read by another reader; an empty one if it is not set.
  XmlRpc::XmlRpcValue optionalMap(const std::string & key);

  std::string fullName(const std::string & key) const { return name_ + "/" + key; }
  [[noreturn]] void fail(const std::string & key, const std::string & expected) const;

private:
  const std::string name_;
  XmlRpc::XmlRpcValue value_;
};

/// "a, b, c"
std::string joined(const std::vector<std::string> & words);
}  // namespace f1tenth_sim2d
