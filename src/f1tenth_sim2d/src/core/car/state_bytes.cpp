#include "core/car/state_bytes.h"

#include <cstring>
#include <iterator>

namespace f1tenth_sim2d
{
void appendBytes(const BodyState & s, std::vector<std::uint8_t> & bytes)
{
  const double values[]{s.x, s.y, s.delta, s.v, s.psi, s.psi_dot, s.beta};
  std::uint8_t buffer[sizeof(values)];
  for (std::size_t i = 0; i < std::size(values); ++i) {
    std::uint64_t bits = 0;
    static_assert(sizeof(bits) == sizeof(values[i]));
    std::memcpy(&bits, &values[i], sizeof(bits));
    for (std::size_t byte = 0; byte < 8; ++byte) {
      buffer[8 * i + byte] = static_cast<std::uint8_t>(bits >> (8 * byte));
    }
  }
  bytes.insert(bytes.end(), std::begin(buffer), std::end(buffer));
}
}  // namespace f1tenth_sim2d
