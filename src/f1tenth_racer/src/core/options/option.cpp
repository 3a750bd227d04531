#include "options/option.h"

#include <workspace_support/option_checks.h>

namespace f1tenth_racer
{
const char * describe(Option::Range range)
{
  switch (range) {
    case Option::Range::kPositive:
      return "a number above 0";
    case Option::Range::kNotNegative:
      return "a number of at least 0";
    case Option::Range::kPart:
      return "above 0 and at most 1";
    case Option::Range::kSteering:
      return "above 0 and below pi/2";
  }
  return "";
}

void check(const Option & option, double value)
{
  const bool is_positive = std::isfinite(value) && value > 0.0;
  const bool holds = option.range == Option::Range::kPart       ? is_positive && value <= 1.0
                     : option.range == Option::Range::kSteering ? is_positive && value < 0.5 * M_PI
                     : option.range == Option::Range::kPositive ? is_positive
                                                                : is_positive || value == 0.0;
  workspace_support::requireOption(holds, option.name, value, describe(option.range));
}
}  // namespace f1tenth_racer
