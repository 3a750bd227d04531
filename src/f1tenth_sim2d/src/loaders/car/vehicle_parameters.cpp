#include "f1tenth_sim2d/vehicle_parameters.h"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <set>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
struct Range
{
  double least;
  double greatest;
  bool least_included;
  const char * text;

  bool contains(double value) const
  {
    return std::isfinite(value) && value <= greatest && (value > least || (least_included && value == least));
  }
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kPositive{0.0, kInfinity, false, "numbers greater than 0"};
constexpr Range kNotNegative{0.0, kInfinity, true, "numbers from 0"};
constexpr Range kNotPositive{-kInfinity, 0.0, true, "numbers up to 0"};
constexpr Range kSteeringAngle{0.0, 1.5, false, "numbers greater than 0, up to 1.5 rad"};
constexpr Range kSteeringOffset{-1.5, 1.5, true, "numbers from -1.5 to 1.5 rad"};
constexpr Range kLatency{0.0, 1.0, true, "numbers from 0 to 1 s"};
constexpr Range kRate{0.0, 1000.0, false, "numbers greater than 0, up to 1000 Hz"};

struct Key
{
  const char * name;
  double VehicleParameters::*member;
  Range range;
};

using P = VehicleParameters;
constexpr std::array<Key, 22> kKeys{{
  {"m", &P::m, kPositive},
  {"l_f", &P::l_f, kPositive},
  {"l_r", &P::l_r, kPositive},
  {"h", &P::h, kNotNegative},
  {"I_z", &P::I_z, kPositive},
  {"mu", &P::mu, kPositive},
  {"C_Sf", &P::C_Sf, kPositive},
  {"C_Sr", &P::C_Sr, kPositive},
  {"steering_max", &P::steering_max, kSteeringAngle},
  {"steering_rate_max", &P::steering_rate_max, kPositive},
  {"a_max", &P::a_max, kPositive},
  {"v_switch", &P::v_switch, kPositive},
  {"v_min", &P::v_min, kNotPositive},
  {"v_max", &P::v_max, kPositive},
  {"actuation_latency", &P::actuation_latency, kLatency},
  {"speed_gain", &P::speed_gain, kPositive},
  {"command_timeout", &P::command_timeout, kPositive},
  {"odometry_rate_hz", &P::odometry_rate_hz, kRate},
  {"odometry_speed_scale", &P::odometry_speed_scale, kPositive},
  {"odometry_speed_noise_stddev", &P::odometry_speed_noise_stddev, kNotNegative},
  {"odometry_steering_offset", &P::odometry_steering_offset, kSteeringOffset},
  {"odometry_steering_noise_stddev", &P::odometry_steering_noise_stddev, kNotNegative},
}};

[[noreturn]] void fail(const std::string & path, const YAML::Mark & mark, const std::string & reason)
{
  throw LoadError(path + ":" + std::to_string(mark.line + 1), "", reason);
}

std::string allowedKeys()
{
  std::string names;
  for (const Key & key : kKeys) {
    names += (names.empty() ? "" : ", ") + std::string(key.name);
  }
  return names;
}

const Key & findKey(const std::string & path, const YAML::Node & node)
{
  for (const Key & key : kKeys) {
    if (node.IsScalar() && node.Scalar() == key.name) {
      return key;
    }
  }
  const std::string name = node.IsScalar() ? "'" + node.Scalar() + "'" : "that is no word";
  fail(path, node.Mark(), "unknown key " + name + ", allowed are " + allowedKeys());
}

double readNumber(const std::string & path, const Key & key, const YAML::Node & node)
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

YAML::Node readFile(const std::string & path)
{
  try {
    return YAML::LoadFile(path);
  } catch (const YAML::BadFile &) {
    throw LoadError(path, "", "no such file, or it cannot be read");
  } catch (const YAML::ParserException & error) {
    fail(path, error.mark, "not YAML: " + error.msg);
  }
}
}  // namespace

VehicleParameters loadVehicleParameters(const std::string & path)
{
  const YAML::Node root = readFile(path);
  VehicleParameters parameters;
  if (root.IsNull()) {
    return parameters;
  }
  if (!root.IsMap()) {
    fail(path, root.Mark(), "not a map, allowed are lines 'key: number'");
  }
  std::set<std::string> seen;
  for (const auto & entry : root) {
    const Key & key = findKey(path, entry.first);
    if (!seen.insert(key.name).second) {
      fail(path, entry.first.Mark(), std::string(key.name) + " is given twice");
    }
    parameters.*key.member = readNumber(path, key, entry.second);
  }
  return parameters;
}
}  // namespace f1tenth_sim2d
