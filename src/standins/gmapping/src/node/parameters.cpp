#include "parameters.h"

#include <workspace_support/conversions.h>
#include <workspace_support/parameter_reader.h>

#include "gmapping/geometry.h"

namespace gmapping
{
namespace
{
void readFrames(ParameterReader & reader, NodeParameters & parameters)
{
  const auto read = [&reader](const std::string & name, std::string & frame) {
    reader.read(name, frame);
    frame = withoutSlash(frame);
  };
  read("base_frame", parameters.base_frame);
  read("map_frame", parameters.map_frame);
  read("odom_frame", parameters.odom_frame);
}

void readNode(ParameterReader & reader, NodeParameters & parameters)
{
  reader.read("throttle_scans", parameters.throttle_scans, atLeast(1));
  reader.read("map_update_interval", parameters.map_update_interval, duration());
  reader.read("transform_publish_period", parameters.transform_publish_period, duration());
  parameters.tf_delay = parameters.transform_publish_period;
  reader.read("tf_delay", parameters.tf_delay, duration());
  reader.read("lockstep", parameters.lockstep);
}

void readFilter(ParameterReader & reader, SlamOptions & slam)
{
  reader.read("srr", slam.motion.srr);
  reader.read("srt", slam.motion.srt);
  reader.read("str", slam.motion.str);
  reader.read("stt", slam.motion.stt);
  reader.read("linearUpdate", slam.linear_update);
  reader.read("angularUpdate", slam.angular_update);
  reader.read("temporalUpdate", slam.temporal_update);
  // Nothing here is drawn at random; known all the same, as whoever gives it wants the same map every time.
  int seed = 0;
  reader.read("seed", seed);
}

void readMatcher(ParameterReader & reader, MatcherOptions & matcher)
{
  reader.read("sigma", matcher.sigma);
  reader.read("kernelSize", matcher.kernel_size);
  reader.read("iterations", matcher.iterations);
  reader.read("lskip", matcher.lskip);
  reader.read("minimumScore", matcher.minimum_score);
}

void readMap(ParameterReader & reader, SlamOptions & slam)
{
  reader.read("maxRange", slam.max_range);
  reader.read("maxUrange", slam.max_urange);
  reader.read("xmin", slam.xmin);
  reader.read("ymin", slam.ymin);
  reader.read("xmax", slam.xmax);
  reader.read("ymax", slam.ymax);
  reader.read("delta", slam.delta);
  reader.read("occ_thresh", slam.occ_thresh);
}
}  // namespace

NodeParameters readParameters(const ros::NodeHandle & node)
{
  ParameterReader reader(node);
  NodeParameters parameters;
  readFrames(reader, parameters);
  readNode(reader, parameters);
  readFilter(reader, parameters.slam);
  readMatcher(reader, parameters.slam.matcher);
  readMap(reader, parameters.slam);
  reader.check([&] { parameters.slam.validate(); });
  reader.warnOfUnused();
  return parameters;
}
}  // namespace gmapping
