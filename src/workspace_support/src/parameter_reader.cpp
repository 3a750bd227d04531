#include "workspace_support/parameter_reader.h"

#include <ros/console.h>

#include "workspace_support/errors.h"

namespace workspace_support
{
namespace
{
const char * nameOf(double)
{
  return "a number";
}
const char * nameOf(int)
{
  return "a whole number";
}
const char * nameOf(bool)
{
  return "true or false";
}
const char * nameOf(const std::string &)
{
  return "a text";
}
}  // namespace

template <class Value>
void ParameterReader::read(const std::string & name, Value & value)
{
  known_.insert(name);
  XmlRpc::XmlRpcValue raw;
  if (node_.getParam(name, raw) && !node_.getParam(name, value)) {
    throw OptionError(node_.resolveName(name) + ": found " + raw.toXml() + ", must be " + nameOf(value));
  }
}

template <class Value>
void ParameterReader::read(const std::string & name, std::optional<Value> & value)
{
  known_.insert(name);
  if (node_.hasParam(name)) {
    read(name, value.emplace());
  }
}

template void ParameterReader::read(const std::string & name, double & value);
template void ParameterReader::read(const std::string & name, int & value);
template void ParameterReader::read(const std::string & name, bool & value);
template void ParameterReader::read(const std::string & name, std::string & value);
template void ParameterReader::read(const std::string & name, std::optional<double> & value);

std::vector<std::string> ParameterReader::unused() const
{
  const std::string prefix = node_.getNamespace() + "/";
  std::vector<std::string> all;
  node_.getParamNames(all);
  std::set<std::string> names;
  for (const std::string & name : all) {
    const bool own = name.compare(0, prefix.size(), prefix) == 0;
    if (own && known_.count(name.substr(prefix.size())) == 0) {
      names.insert(name.substr(prefix.size()));
    }
  }
  return {names.begin(), names.end()};
}

void ParameterReader::warnOfUnused() const
{
  std::string names;
  for (const std::string & name : unused()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) {
    ROS_WARN("This stand-in has no use for these parameters: %s", names.c_str());
  }
}
}  // namespace workspace_support
