#pragma once

#include <cmath>

namespace f1tenth_racer
{
/// What an option is called, as a ROS parameter and in Python, and what it may be.
struct Option
{
  enum class Range
  {
    kPositive,
    kNotNegative,
    kPart,     ///< above 0, at most 1
    kSteering  ///< above 0, below a right angle
  };

  const char * name;
  const char * unit;
  const char * meaning;
  Range range;
};

/// For example "a number above 0".
const char * describe(Option::Range range);

/// @throws OptionError
void check(const Option & option, double value);
inline void check(const Option &, bool) {}

/// @param options  a struct whose visitEach(options, visit) calls visit(option, value) for each
/// @throws OptionError for the first that is out of range
template <class Options>
void checkEach(const Options & options)
{
  Options::visitEach(options, [](const Option & option, const auto & value) { check(option, value); });
}
}  // namespace f1tenth_racer
