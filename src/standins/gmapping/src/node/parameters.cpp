#include "parameters.h"

#include <ros/console.h>

#include <set>
#include <vector>

#include "gmapping/errors.h"

namespace gmapping
{
namespace
{
// Of the original's search, which goes other ways.
const std::vector<std::string> kUnused{"lstep",        "astep",         "llsamplerange",
                                       "llsamplestep", "lasamplerange", "lasamplestep"};

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

template <class Value>
bool read(const ros::NodeHandle & node, const std::string & name, Value & value)
{
  XmlRpc::XmlRpcValue raw;
  if (!node.getParam(name, raw)) {
    return false;
  }
  if (!node.getParam(name, value)) {
    throw OptionError(node.resolveName(name) + ": found " + raw.toXml() + ", must be " + nameOf(value));
  }
  return true;
}

template <class Value>
void read(const ros::NodeHandle & node, const std::string & name, std::optional<Value> & value)
{
  Value given{};
  if (read(node, name, given)) {
    value = given;
  }
}

void readFilter(const ros::NodeHandle & node, SlamOptions & slam)
{
  read(node, "srr", slam.motion.srr);
  read(node, "srt", slam.motion.srt);
  read(node, "str", slam.motion.str);
  read(node, "stt", slam.motion.stt);
  read(node, "ogain", slam.ogain);
  read(node, "linearUpdate", slam.linear_update);
  read(node, "angularUpdate", slam.angular_update);
  read(node, "temporalUpdate", slam.temporal_update);
  read(node, "resampleThreshold", slam.resample_threshold);
  read(node, "particles", slam.particles);
  int seed = 0;
  read(node, "seed", seed);
  slam.seed = static_cast<std::uint32_t>(seed);
}

void readMatcher(const ros::NodeHandle & node, MatcherOptions & matcher)
{
  read(node, "sigma", matcher.sigma);
  read(node, "kernelSize", matcher.kernel_size);
  read(node, "iterations", matcher.iterations);
  read(node, "lsigma", matcher.lsigma);
  read(node, "lskip", matcher.lskip);
  read(node, "minimumScore", matcher.minimum_score);
}

void readMap(const ros::NodeHandle & node, SlamOptions & slam)
{
  read(node, "maxRange", slam.max_range);
  read(node, "maxUrange", slam.max_urange);
  read(node, "xmin", slam.xmin);
  read(node, "ymin", slam.ymin);
  read(node, "xmax", slam.xmax);
  read(node, "ymax", slam.ymax);
  read(node, "delta", slam.delta);
  read(node, "occ_thresh", slam.occ_thresh);
}

void warnOfUnused(const ros::NodeHandle & node)
{
  std::string names;
  for (const std::string & name : kUnused) {
    if (node.hasParam(name)) {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  if (!names.empty()) {
    ROS_WARN("This stand-in has no use for these parameters: %s", names.c_str());
  }
}
}  // namespace

NodeParameters readParameters(const ros::NodeHandle & node)
{
  NodeParameters parameters;
  read(node, "base_frame", parameters.base_frame);
  read(node, "map_frame", parameters.map_frame);
  read(node, "odom_frame", parameters.odom_frame);
  read(node, "throttle_scans", parameters.throttle_scans);
  read(node, "map_update_interval", parameters.map_update_interval);
  read(node, "transform_publish_period", parameters.transform_publish_period);
  parameters.tf_delay = parameters.transform_publish_period;
  read(node, "tf_delay", parameters.tf_delay);
  read(node, "lockstep", parameters.lockstep);
  readFilter(node, parameters.slam);
  readMatcher(node, parameters.slam.matcher);
  readMap(node, parameters.slam);
  if (parameters.throttle_scans < 1) {
    throw OptionError("throttle_scans: found " + std::to_string(parameters.throttle_scans) + ", must be 1 or above");
  }
  parameters.slam.validate();
  warnOfUnused(node);
  return parameters;
}
}  // namespace gmapping
