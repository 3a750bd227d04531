#include "gmapping/slam_options.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "gmapping/geometry.h"

namespace gmapping
{
namespace
{
void requireAbove(const std::string & name, double value, const std::string & other, double least)
{
  std::ostringstream allowed;
  allowed << "above " << other << ", which is " << least;
  requireOption(std::isfinite(value) && value > least, name, value, allowed.str());
}

void validateMatcher(const MatcherOptions & options)
{
  requirePositive("sigma", options.sigma);
  requireNotNegative("kernelSize", options.kernel_size);
  requirePositive("iterations", options.iterations);
  requireNotNegative("lskip", options.lskip);
}

void validateMotion(const MotionNoise & noise)
{
  requireNotNegative("srr", noise.srr);
  requireNotNegative("srt", noise.srt);
  requireNotNegative("str", noise.str);
  requireNotNegative("stt", noise.stt);
}

void validateExtent(const SlamOptions & options)
{
  // With it, a new map, which has a side of 20 m, has kMostCells.
  requireOption(std::isfinite(options.delta) && options.delta >= 0.001, "delta", options.delta, "at least 0.001");
  requireAbove("xmax", options.xmax, "xmin", options.xmin);
  requireAbove("ymax", options.ymax, "ymin", options.ymin);
  const double columns = std::max(1.0, (options.xmax - options.xmin) / options.delta);
  const double rows = std::max(1.0, (options.ymax - options.ymin) / options.delta);
  std::ostringstream allowed;
  allowed << "at most " << kMostCells << " cells";
  requireOption(columns * rows <= kMostCells, "xmin, xmax, ymin, ymax, delta", columns * rows, allowed.str());
}
}  // namespace

void SlamOptions::validate() const
{
  validateMotion(motion);
  validateMatcher(matcher);
  validateExtent(*this);
  requirePositive("maxRange", max_range.value_or(1.0));
  requirePositive("maxUrange", max_urange.value_or(1.0));
  requireNotNegative("linearUpdate", linear_update);
  requireNotNegative("angularUpdate", angular_update);
  requireNotNegative("occ_thresh", occ_thresh);
}
}  // namespace gmapping
