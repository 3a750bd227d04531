#include "state_bytes.h"

#include <cstring>

namespace f1tenth_sim2d
{
void appendBytes(const SingleTrackState & s, std::vector<std::uint8_t> & bytes)
{
  for (const double value : {s.x, s.y, s.delta, s.v, s.psi, s.psi_dot, s.beta}) {
    std::uint64_t bits = 0;
    static_assert(sizeof(bits) == sizeof(value));
    std::memcpy(&bits, &value, sizeof(bits));
    for (int shift = 0; shift < 64; shift += 8) {
      bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
  }
}
}  // namespace f1tenth_sim2d
