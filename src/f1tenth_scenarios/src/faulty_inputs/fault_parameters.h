#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "faulty_line.h"

namespace f1tenth_scenarios
{
/// A parameter that cannot be used.
class FaultParameterError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Reads the parameter `faults`: a list of {input, at, until, delay}, the times in s, delay optional.
/// @return the faults by input: scan, odom, tf
/// @throws FaultParameterError
std::map<std::string, std::vector<InputFault>> readFaults(XmlRpc::XmlRpcValue & list);
}  // namespace f1tenth_scenarios
