#include "core/math/noise.h"

#include <workspace_support/maths/exponential.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/simd.h"

namespace f1tenth_sim2d
{
namespace maths = workspace_support::maths;

namespace
{
constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15ULL;

double density(double x)
{
  return maths::exp(-0.5 * x * x);
}

/// The ziggurat of Marsaglia and Tsang (2000): equal areas under the half normal density, stacked.
/// Layer 0 is the base with the tail; layer i spans density(edge[i]) to density(edge[i + 1]).
struct Ziggurat
{
  static constexpr int kLayers = 256;
  static constexpr double kTailStart = 3.6541528853610088;
  static constexpr double kArea = 0.00492867323399;

  std::array<double, kLayers + 1> edge{};
  std::array<double, kLayers + 1> height{};
  std::array<double, kLayers> accept{};  ///< share of a layer's width that lies under the density all over

  Ziggurat()
  {
    edge[0] = kArea / density(kTailStart);
    edge[1] = kTailStart;
    for (int i = 2; i < kLayers; ++i) {
      edge[i] = std::sqrt(-2.0 * maths::log(kArea / edge[i - 1] + density(edge[i - 1])));
    }
    edge[kLayers] = 0.0;
    for (int i = 0; i <= kLayers; ++i) {
      height[i] = density(edge[i]);
    }
    for (int i = 0; i < kLayers; ++i) {
      accept[i] = edge[i + 1] / edge[i];
    }
  }
};

const Ziggurat kZiggurat;

/// Uniform in (0, 1).
double openUniform(std::uint64_t bits)
{
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

/// Marsaglia's tail: beyond kTailStart.
double tail(std::uint64_t bits)
{
  for (;;) {
    bits = mixBits(bits + kGoldenGamma);
    const double x = -maths::log(openUniform(bits)) / Ziggurat::kTailStart;
    bits = mixBits(bits + kGoldenGamma);
    const double y = -maths::log(openUniform(bits));
    if (2.0 * y > x * x) {
      return Ziggurat::kTailStart + x;
    }
  }
}

/// Bits of sample `index` under a key.
inline std::uint64_t bitsOf(std::uint64_t key, std::uint64_t index)
{
  return mixBits(key + (index + 1) * kGoldenGamma);
}

/// A point of a layer: the layer in the lowest 8 bits, the place in the highest 53.
struct Draw
{
  explicit Draw(std::uint64_t b)
  : bits(b), layer(b & 255U), u(static_cast<double>(static_cast<std::int64_t>(b) >> 11) * 0x1p-52)
  {
  }
  double value() const { return u * kZiggurat.edge[layer]; }
  /// Whether it lies where the layer is under the density all over.
  bool isCovered() const { return std::abs(u) < kZiggurat.accept[layer]; }

  std::uint64_t bits;
  std::uint64_t layer;
  double u;
};

/// The one sample in a hundred that the fast path leaves open.
double gaussianSlow(std::uint64_t bits)
{
  for (;;) {
    const Draw draw(bits);
    const double x = draw.value();
    if (draw.isCovered()) {
      return x;
    }
    if (draw.layer == 0) {
      return std::copysign(tail(bits), draw.u);
    }
    bits = mixBits(bits + kGoldenGamma);
    const double low = kZiggurat.height[draw.layer];
    const double high = kZiggurat.height[draw.layer + 1];
    if (low + openUniform(bits) * (high - low) < density(x)) {
      return x;
    }
    bits = mixBits(bits + kGoldenGamma);
  }
}
}  // namespace

std::uint64_t noiseKey(
  std::uint64_t seed, std::uint64_t car, NoiseStream stream, std::uint64_t sensor, std::uint64_t instant)
{
  std::uint64_t key = seed;
  for (const std::uint64_t part : {car, static_cast<std::uint64_t>(stream), sensor, instant}) {
    key = mixBits(key + kGoldenGamma) + part;
  }
  return mixBits(key + kGoldenGamma);
}

std::uint64_t hashOf(const std::string & name)
{
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : name) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  return hash;
}

double gaussian(std::uint64_t key, std::uint64_t index)
{
  const Draw draw(bitsOf(key, index));
  return draw.isCovered() ? draw.value() : gaussianSlow(draw.bits);
}

F1TENTH_VECTORIZED
void gaussians(std::uint64_t key, std::size_t count, double * __restrict samples)
{
  constexpr std::size_t kBlock = 64;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t size = std::min(kBlock, count - begin);
    std::array<std::uint64_t, kBlock> is_open;
    std::uint64_t any_open = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Draw draw(bitsOf(key, begin + i));
      samples[begin + i] = draw.value();
      is_open[i] = draw.isCovered() ? 0 : 1;
      any_open |= is_open[i];
    }
    for (std::size_t i = 0; any_open != 0 && i < size; ++i) {
      if (is_open[i] != 0) {
        samples[begin + i] = gaussianSlow(bitsOf(key, begin + i));
      }
    }
  }
}
}  // namespace f1tenth_sim2d
