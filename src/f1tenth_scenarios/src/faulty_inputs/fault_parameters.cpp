#include "fault_parameters.h"

#include <set>

namespace f1tenth_scenarios
{
namespace
{
using XmlRpc::XmlRpcValue;

const std::set<std::string> kInputs{"odom", "scan", "tf"};

class FaultReader
{
public:
  FaultReader(XmlRpcValue & fault, int index) : fault_(fault), where_("~faults[" + std::to_string(index) + "]")
  {
    if (fault_.getType() != XmlRpcValue::TypeStruct) {
      fail(" must hold input, at, until and, if wanted, delay");
    }
  }

  std::string input()
  {
    if (!fault_.hasMember("input") || fault_["input"].getType() != XmlRpcValue::TypeString) {
      fail("/input must be odom, scan or tf");
    }
    const auto name = static_cast<std::string>(fault_["input"]);
    if (kInputs.count(name) == 0) {
      fail("/input is \"" + name + "\", must be odom, scan or tf");
    }
    return name;
  }

  InputFault fault()
  {
    const double at = seconds("at");
    const double until = seconds("until");
    if (until <= at) {
      fail("/until must be after at");
    }
    return {at, until, fault_.hasMember("delay") ? std::optional<double>(seconds("delay")) : std::nullopt};
  }

private:
  double seconds(const std::string & key)
  {
    if (fault_.hasMember(key) && fault_[key].getType() == XmlRpcValue::TypeInt) {
      return static_cast<int>(fault_[key]);
    }
    if (!fault_.hasMember(key) || fault_[key].getType() != XmlRpcValue::TypeDouble) {
      fail("/" + key + " must be a number (s)");
    }
    return static_cast<double>(fault_[key]);
  }

  [[noreturn]] void fail(const std::string & text) const { throw FaultParameterError(where_ + text); }

  XmlRpcValue & fault_;
  std::string where_;
};
}  // namespace

std::map<std::string, std::vector<InputFault>> readFaults(XmlRpcValue & list)
{
  if (list.getType() != XmlRpcValue::TypeArray) {
    throw FaultParameterError("~faults must be a list of faults");
  }
  std::map<std::string, std::vector<InputFault>> faults;
  for (int index = 0; index < list.size(); ++index) {
    FaultReader reader(list[index], index);
    faults[reader.input()].push_back(reader.fault());
  }
  return faults;
}
}  // namespace f1tenth_scenarios
