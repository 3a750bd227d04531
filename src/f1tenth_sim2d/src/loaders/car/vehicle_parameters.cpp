#include "f1tenth_sim2d/vehicle_parameters.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <set>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/vehicle_keys.h"
#include "loaders/files/files.h"

namespace f1tenth_sim2d
{
namespace
{
[[noreturn]] void fail(const std::string & path, const YAML::Mark & mark, const std::string & reason)
{
  throw LoadError(path + ":" + std::to_string(mark.line + 1), "", reason);
}

/// A name, or what is there instead of one.
std::string nameIn(const YAML::Node & node)
{
  return node.IsScalar() ? "'" + node.Scalar() + "'" : "that is no word";
}

template <typename Parameters>
double readNumber(const std::string & path, const vehicle_keys::Key<Parameters> & key, const YAML::Node & node)
{
  double value = 0.0;
  if (!node.IsScalar() || node.Tag() == "!" || !YAML::convert<double>::decode(node, value)) {
    const std::string found = node.IsScalar() ? "'" + node.Scalar() + "'" : "no single value";
    fail(path, node.Mark(), std::string(key.name) + " is " + found + ", allowed are " + key.range.text);
  }
  if (!key.range.contains(value)) {
    fail(path, node.Mark(), std::string(key.name) + " is " + node.Scalar() + ", allowed are " + key.range.text);
  }
  return value;
}

VehicleModel readModel(const std::string & path, const YAML::Node & node)
{
  try {
    return vehicleModel(node.IsScalar() ? node.Scalar() : "");
  } catch (const Error & error) {
    fail(path, node.Mark(), error.what());
  }
}

/// Reads lines 'key: number' into parameters, and other keys by readOther(name, node), which is false for unknown ones.
/// @param others  the other keys, for the message
template <typename Parameters, std::size_t count, typename ReadOther>
void readMap(
  const std::string & path, const YAML::Node & map, const std::array<vehicle_keys::Key<Parameters>, count> & keys,
  Parameters & parameters, const std::string & others, ReadOther readOther)
{
  if (!map.IsMap()) {
    fail(path, map.Mark(), "not a map, allowed are lines 'key: number'");
  }
  std::set<std::string> seen;
  for (const auto & entry : map) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (!seen.insert(name).second) {
      fail(path, entry.first.Mark(), name + " is given twice");
    }
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto & each) { return name == each.name; });
    if (key != keys.end()) {
      parameters.*key->member = readNumber(path, *key, entry.second);
    } else if (!readOther(name, entry.second)) {
      std::string allowed = others;
      for (const auto & each : keys) {
        allowed += (allowed.empty() ? "" : ", ") + std::string(each.name);
      }
      fail(path, entry.first.Mark(), "unknown key " + nameIn(entry.first) + ", allowed are " + allowed);
    }
  }
}

YAML::Node readYaml(const std::string & path)
{
  try {
    return YAML::Load(readFile(path));
  } catch (const YAML::ParserException & error) {
    fail(path, error.mark, "not YAML: " + error.msg);
  }
}
}  // namespace

VehicleModel vehicleModel(const std::string & name)
{
  const auto & names = kVehicleModelNames;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) {
    return static_cast<VehicleModel>(found - names.begin());
  }
  const std::string allowed = boost::algorithm::join(std::vector<std::string>(names.begin(), names.end()), ", ");
  throw Error("model is '" + name + "', allowed are " + allowed);
}

VehicleParameters loadVehicleParameters(const std::string & path)
{
  const YAML::Node root = readYaml(path);
  VehicleParameters parameters;
  if (root.IsNull()) {
    return parameters;
  }
  readMap(
    path, root, vehicle_keys::kVehicle, parameters, "model, tire",
    [&](const std::string & name, const YAML::Node & node) {
      if (name == "model") {
        parameters.model = readModel(path, node);
      } else if (name == "tire") {
        readMap(path, node, vehicle_keys::kTire, parameters.tire, "", [](const auto &, const auto &) { return false; });
      }
      return name == "model" || name == "tire";
    });
  return parameters;
}
}  // namespace f1tenth_sim2d
