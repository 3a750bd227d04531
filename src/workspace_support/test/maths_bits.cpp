#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "workspace_support/maths/exponential.h"
#include "workspace_support/maths/random.h"
#include "workspace_support/maths/trigonometry.h"

/// A hash of the bits of all functions at 100,000 places. The test compiles this file for two processors and gives
/// each a name of its own.
std::uint64_t MATHS_BITS()
{
  namespace maths = workspace_support::maths;
  maths::Random random(1);
  std::uint64_t hash = 0;
  const auto take = [&hash](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = maths::mixBits(hash + bits);
  };
  for (int i = 0; i < 100000; ++i) {
    const double small = random.uniform(-1.0, 1.0);
    const double large = random.uniform(-100.0, 100.0);
    for (const double x : {small, large}) {
      take(maths::sin(x));
      take(maths::cos(x));
      take(maths::tan(x));
      take(maths::atan(x));
      take(maths::exp(x));
      take(maths::log(std::abs(x)));
      take(maths::cbrt(x));
    }
    take(maths::asin(small));
    take(maths::acos(small));
    take(maths::atan2(small, large));
    take(maths::hypot(small, large));
    take(maths::pow(std::abs(large), small));
    take(random.gaussian());
  }
  return hash;
}
