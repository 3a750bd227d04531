#include "f1tenth_sim2d/vehicle_parameters.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
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
constexpr Range kShare{0.0, 1.0, true, "numbers from 0 to 1"};
constexpr Range kNegative{-kInfinity, -1e-9, true, "numbers less than 0"};
constexpr Range kCurvature{-kInfinity, 1.0, true, "numbers up to 1"};
constexpr Range kFinite{-kInfinity, kInfinity, true, "numbers"};
constexpr Range kRate{0.0, 1000.0, false, "numbers greater than 0, up to 1000 Hz"};

template <typename Parameters>
struct Key
{
  const char * name;
  double Parameters::*member;
  Range range;
};

using P = VehicleParameters;
constexpr std::array kKeys{
  Key<P>{"m", &P::m, kPositive},
  Key<P>{"l_f", &P::l_f, kPositive},
  Key<P>{"l_r", &P::l_r, kPositive},
  Key<P>{"h", &P::h, kNotNegative},
  Key<P>{"I_z", &P::I_z, kPositive},
  Key<P>{"mu", &P::mu, kPositive},
  Key<P>{"C_Sf", &P::C_Sf, kPositive},
  Key<P>{"C_Sr", &P::C_Sr, kPositive},
  Key<P>{"steering_max", &P::steering_max, kSteeringAngle},
  Key<P>{"steering_rate_max", &P::steering_rate_max, kPositive},
  Key<P>{"a_max", &P::a_max, kPositive},
  Key<P>{"v_switch", &P::v_switch, kPositive},
  Key<P>{"v_min", &P::v_min, kNotPositive},
  Key<P>{"v_max", &P::v_max, kPositive},
  Key<P>{"actuation_latency", &P::actuation_latency, kLatency},
  Key<P>{"speed_gain", &P::speed_gain, kPositive},
  Key<P>{"command_timeout", &P::command_timeout, kPositive},
  Key<P>{"R_w", &P::R_w, kPositive},
  Key<P>{"I_y_w", &P::I_y_w, kPositive},
  Key<P>{"T_sb", &P::T_sb, kShare},
  Key<P>{"T_se", &P::T_se, kShare},
  Key<P>{"odometry_rate_hz", &P::odometry_rate_hz, kRate},
  Key<P>{"odometry_speed_scale", &P::odometry_speed_scale, kPositive},
  Key<P>{"odometry_speed_noise_stddev", &P::odometry_speed_noise_stddev, kNotNegative},
  Key<P>{"odometry_steering_offset", &P::odometry_steering_offset, kSteeringOffset},
  Key<P>{"odometry_steering_noise_stddev", &P::odometry_steering_noise_stddev, kNotNegative}};

using T = TireParameters;
constexpr std::array kTireKeys{Key<T>{"p_cx1", &T::p_cx1, kPositive},  Key<T>{"p_dx1", &T::p_dx1, kPositive},
                               Key<T>{"p_ex1", &T::p_ex1, kCurvature}, Key<T>{"p_kx1", &T::p_kx1, kPositive},
                               Key<T>{"p_hx1", &T::p_hx1, kFinite},    Key<T>{"p_vx1", &T::p_vx1, kFinite},
                               Key<T>{"r_bx1", &T::r_bx1, kFinite},    Key<T>{"r_bx2", &T::r_bx2, kFinite},
                               Key<T>{"r_cx1", &T::r_cx1, kFinite},    Key<T>{"r_ex1", &T::r_ex1, kCurvature},
                               Key<T>{"r_hx1", &T::r_hx1, kFinite},    Key<T>{"p_cy1", &T::p_cy1, kPositive},
                               Key<T>{"p_dy1", &T::p_dy1, kPositive},  Key<T>{"p_ey1", &T::p_ey1, kCurvature},
                               Key<T>{"p_ky1", &T::p_ky1, kNegative},  Key<T>{"r_by1", &T::r_by1, kFinite},
                               Key<T>{"r_by2", &T::r_by2, kFinite},    Key<T>{"r_by3", &T::r_by3, kFinite},
                               Key<T>{"r_cy1", &T::r_cy1, kFinite},    Key<T>{"r_ey1", &T::r_ey1, kCurvature},
                               Key<T>{"r_hy1", &T::r_hy1, kFinite},    Key<T>{"r_vy1", &T::r_vy1, kFinite},
                               Key<T>{"r_vy4", &T::r_vy4, kFinite},    Key<T>{"r_vy5", &T::r_vy5, kFinite},
                               Key<T>{"r_vy6", &T::r_vy6, kFinite}};

[[noreturn]] void fail(const std::string & path, const YAML::Mark & mark, const std::string & reason)
{
  throw LoadError(path + ":" + std::to_string(mark.line + 1), "", reason);
}

/// A name, or what stands in the place of one.
std::string nameIn(const YAML::Node & node)
{
  return node.IsScalar() ? "'" + node.Scalar() + "'" : "that is no word";
}

template <typename Parameters>
double readNumber(const std::string & path, const Key<Parameters> & key, const YAML::Node & node)
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

/// Reads lines 'key: number' into parameters, and those of other keys by readOther(name, node) unless that is false.
/// @param others  the other keys, for the message
template <typename Parameters, std::size_t count, typename ReadOther>
void readMap(
  const std::string & path, const YAML::Node & map, const std::array<Key<Parameters>, count> & keys,
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

VehicleModel vehicleModel(const std::string & name)
{
  std::string allowed;
  for (std::size_t i = 0; i < kVehicleModelNames.size(); ++i) {
    if (name == kVehicleModelNames[i]) {
      return static_cast<VehicleModel>(i);
    }
    allowed += (i == 0 ? "" : ", ") + std::string(kVehicleModelNames[i]);
  }
  throw Error("model is '" + name + "', allowed are " + allowed);
}

VehicleParameters loadVehicleParameters(const std::string & path)
{
  const YAML::Node root = readFile(path);
  VehicleParameters parameters;
  if (root.IsNull()) {
    return parameters;
  }
  readMap(path, root, kKeys, parameters, "model, tire", [&](const std::string & name, const YAML::Node & node) {
    if (name == "model") {
      parameters.model = readModel(path, node);
    } else if (name == "tire") {
      readMap(path, node, kTireKeys, parameters.tire, "", [](const auto &, const auto &) { return false; });
    }
    return name == "model" || name == "tire";
  });
  return parameters;
}
}  // namespace f1tenth_sim2d
