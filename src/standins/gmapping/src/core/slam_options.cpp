#include "gmapping/slam_options.h"

#include <cmath>
#include <string>

#include "gmapping/errors.h"

namespace gmapping
{
namespace
{
void refuse(const std::string & name, double found, const std::string & allowed)
{
  throw OptionError(name + ": found " + std::to_string(found) + ", must be " + allowed);
}

void expectPositive(const std::string & name, double value)
{
  if (!(std::isfinite(value) && value > 0.0)) {
    refuse(name, value, "above 0");
  }
}

void expectNotNegative(const std::string & name, double value)
{
  if (!(std::isfinite(value) && value >= 0.0)) {
    refuse(name, value, "0 or above");
  }
}

void expectAbove(const std::string & name, double value, const std::string & other, double least)
{
  if (!(std::isfinite(value) && value > least)) {
    refuse(name, value, "above " + other + ", which is " + std::to_string(least));
  }
}

void validateMatcher(const MatcherOptions & options)
{
  expectPositive("sigma", options.sigma);
  expectNotNegative("kernelSize", options.kernel_size);
  expectPositive("iterations", options.iterations);
  expectNotNegative("lskip", options.lskip);
}

void validateMotion(const MotionNoise & noise)
{
  expectNotNegative("srr", noise.srr);
  expectNotNegative("srt", noise.srt);
  expectNotNegative("str", noise.str);
  expectNotNegative("stt", noise.stt);
}

void validateExtent(const SlamOptions & options)
{
  expectPositive("delta", options.delta);
  expectAbove("xmax", options.xmax, "xmin", options.xmin);
  expectAbove("ymax", options.ymax, "ymin", options.ymin);
}
}  // namespace

void SlamOptions::validate() const
{
  validateMotion(motion);
  validateMatcher(matcher);
  validateExtent(*this);
  expectPositive("maxRange", max_range.value_or(1.0));
  expectPositive("maxUrange", max_urange.value_or(1.0));
  expectNotNegative("linearUpdate", linear_update);
  expectNotNegative("angularUpdate", angular_update);
  expectNotNegative("occ_thresh", occ_thresh);
}
}  // namespace gmapping
