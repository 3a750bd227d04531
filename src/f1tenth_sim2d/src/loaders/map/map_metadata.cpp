#include "loaders/map/map_metadata.h"

#include <workspace_support/maths/trigonometry.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/farthest.h"
#include "loaders/files/files.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr std::array<const char *, 6> kRequiredKeys{"image",  "resolution",      "origin",
                                                    "negate", "occupied_thresh", "free_thresh"};

constexpr double kFinest = 1e-3;  // m; contacts ignore what is much smaller

/// Reads the keys of one file.
class MapKeys
{
public:
  explicit MapKeys(const std::string & path) : path_(path), root_(load())
  {
    if (!root_.IsMap()) {
      throw LoadError(path_, "", "not a map description, allowed are lines 'key: value'");
    }
    requireOnce();
    for (const char * const key : kRequiredKeys) {
      if (!root_[key]) {
        throw LoadError(path_, key, "is missing");
      }
    }
  }

  std::string text(const char * key) const
  {
    const YAML::Node node = root_[key];
    if (!node.IsScalar() || node.Scalar().empty()) {
      fail(key, node, "a file name");
    }
    return node.Scalar();
  }

  int line(const char * key) const { return root_[key].Mark().line + 1; }

  double number(const char * key, double least, double most, const char * allowed) const
  {
    const double value = decoded(root_[key]);
    if (!(value >= least && value <= most)) {
      fail(key, root_[key], allowed);
    }
    return value;
  }

  bool flag(const char * key) const
  {
    bool value = false;
    const double number = decoded(root_[key]);
    if (number == 0.0 || number == 1.0) {
      return number == 1.0;
    }
    if (!root_[key].IsScalar() || !YAML::convert<bool>::decode(root_[key], value)) {
      fail(key, root_[key], "0 or 1");
    }
    return value;
  }

  Pose2 pose(const char * key) const
  {
    const YAML::Node node = root_[key];
    std::array<double, 3> values{NAN, NAN, NAN};
    // map_server ignores what comes after.
    for (std::size_t i = 0; node.IsSequence() && node.size() >= 3 && i < 3; ++i) {
      values[i] = decoded(node[i]);
    }
    if (!(std::abs(values[0]) <= kFarthest && std::abs(values[1]) <= kFarthest && std::isfinite(values[2]))) {
      fail(key, node, "three numbers: x and y (m, up to 100000), yaw (rad)");
    }
    return {values[0], values[1], values[2]};
  }

  /// As in map_server: free pixels are lighter than occupied ones.
  void requireOrder(double free_thresh, double occupied_thresh, bool may_be_equal) const
  {
    if (!(free_thresh < occupied_thresh || (may_be_equal && free_thresh == occupied_thresh))) {
      fail(
        "free_thresh", root_["free_thresh"],
        std::string("a number ") + (may_be_equal ? "up to" : "below") + " occupied_thresh, which is " +
          root_["occupied_thresh"].Scalar());
    }
  }

  MapMetadata::Mode mode() const
  {
    const YAML::Node node = root_["mode"];
    const std::string name = !node ? "trinary" : node.IsScalar() ? node.Scalar() : "";
    if (name == "trinary") {
      return MapMetadata::Mode::kTrinary;
    }
    if (name != "scale" && name != "raw") {
      fail("mode", node, "trinary, scale or raw");
    }
    return name == "scale" ? MapMetadata::Mode::kScale : MapMetadata::Mode::kRaw;
  }

  std::vector<std::string> warnings() const
  {
    std::vector<std::string> result;
    for (const auto & entry : root_) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      if (key != "mode" && std::find(kRequiredKeys.begin(), kRequiredKeys.end(), key) == kRequiredKeys.end()) {
        result.push_back(placed(entry.first, "key '" + key + "' has no meaning"));
      }
    }
    if (const double yaw = pose("origin").yaw; std::abs(yaw) > 2.0 * M_PI) {
      result.push_back(placed(root_["origin"], "the yaw of origin is " + toText(yaw) + " rad, more than a turn"));
    }
    return result;
  }

private:
  std::string placed(const YAML::Node & node, const std::string & text) const
  {
    return path_ + ":" + std::to_string(node.Mark().line + 1) + ": " + text;
  }

  /// Of a key that is given twice, readers of YAML take the first or the last value.
  void requireOnce() const
  {
    std::map<std::string, int> lines;
    for (const auto & entry : root_) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      const int line = entry.first.Mark().line + 1;
      const auto [first, is_new] = lines.emplace(key, line);
      if (!is_new) {
        throw LoadError(
          path_ + ":" + std::to_string(line), key, "is given twice, first in line " + std::to_string(first->second));
      }
    }
  }

  YAML::Node load() const
  {
    try {
      return YAML::Load(readFile(path_));
    } catch (const YAML::ParserException & error) {
      throw LoadError(path_ + ":" + std::to_string(error.mark.line + 1), "", "not YAML: " + error.msg);
    }
  }

  static double decoded(const YAML::Node & node)
  {
    double value = NAN;
    return node.IsScalar() && YAML::convert<double>::decode(node, value) ? value : NAN;
  }

  [[noreturn]] void fail(const char * key, const YAML::Node & node, const std::string & allowed) const
  {
    const std::string found = node.IsScalar()     ? "'" + node.Scalar() + "'"
                              : node.IsSequence() ? "a list of " + std::to_string(node.size())
                                                  : "no single value";
    throw LoadError(
      path_ + ":" + std::to_string(node.Mark().line + 1), key, "found " + found + ", allowed is " + allowed);
  }

  std::string path_;
  YAML::Node root_;
};
}  // namespace

MapMetadata readMapMetadata(const std::string & path)
{
  const MapKeys keys(path);
  MapMetadata metadata;
  metadata.image = (std::filesystem::path(path).parent_path() / keys.text("image")).string();
  metadata.resolution = keys.number("resolution", kFinest, kFarthest, "0.001 to 100000 m");
  metadata.resolution_line = keys.line("resolution");
  metadata.origin = keys.pose("origin");
  metadata.negate = keys.flag("negate");
  metadata.occupied_thresh = keys.number("occupied_thresh", 0.0, 1.0, "a number from 0 to 1");
  metadata.free_thresh = keys.number("free_thresh", 0.0, 1.0, "a number from 0 to 1");
  metadata.mode = keys.mode();
  keys.requireOrder(metadata.free_thresh, metadata.occupied_thresh, metadata.mode != MapMetadata::Mode::kScale);
  metadata.warnings = keys.warnings();
  return metadata;
}

void requireNear(const MapMetadata & metadata, std::size_t width, std::size_t height, const std::string & path)
{
  const double size = maths::hypot(width, height) * metadata.resolution;
  if (std::max(std::abs(metadata.origin.x), std::abs(metadata.origin.y)) + size > kFarthest) {
    throw LoadError(
      path + ":" + std::to_string(metadata.resolution_line), "resolution",
      std::to_string(width) + " by " + std::to_string(height) + " pixels of " + toText(metadata.resolution) +
        " m do not all lie within " + toText(kFarthest) + " m of the world's origin");
  }
}
}  // namespace f1tenth_sim2d
