#include "vector_path.h"

#include "core/lidar/beam_kernels.h"
#include "core/math/noise.h"

// Built once for each vector unit, with a namespace of its own.
namespace f1tenth_sim2d
{
namespace
{
constexpr std::size_t kBeams = 1081;

/// Numbers from -1 to 1 that look random.
double number(std::size_t index)
{
  return static_cast<double>(mixBits(index + 1) >> 11) * 0x1p-52 - 1.0;
}

class Results
{
public:
  explicit Results(double * results) : next_(results), end_(results + kPathResults) {}
  template <typename Value>
  void add(const Value * values, std::size_t count)
  {
    for (std::size_t i = 0; i < count && next_ < end_; ++i) {
      *next_++ = static_cast<double>(values[i]);
    }
  }

private:
  double * next_;
  double * end_;
};

void addWalls(Results & results)
{
  constexpr std::size_t kWalls = SeenWalls::kMost;
  static double ends[4][kWalls];
  for (std::size_t i = 0; i < kWalls; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      ends[k][i] = 10.0 * number(4 * i + k);
    }
  }
  const BeamView view{Transform2({0.3, -0.2, 0.7}), 4.0, -2.35, 229.0, 1439.0, 1080.0};
  static SeenWalls seen;
  projectWalls(view, {ends[0], ends[1], ends[2], ends[3]}, kWalls, seen);
  for (const auto * values :
       {&seen.beam_a, &seen.beam_b, &seen.along_cosine, &seen.along_sine, &seen.first, &seen.last, &seen.kind}) {
    results.add(values->data(), kWalls);
  }
}

void addBeams(Results & results)
{
  static double cosine[kBeams];
  static double sine[kBeams];
  static double inverse[kBeams];
  static double normal[kBeams];
  static float ranges[kBeams];
  for (std::size_t i = 0; i < kBeams; ++i) {
    cosine[i] = number(1000 + i);
    sine[i] = number(5000 + i);
    inverse[i] = i % 7 == 0 ? 0.0 : number(9000 + i) + 1.0;
  }
  drawWall(0.3, -0.7, cosine, sine, inverse, kBeams);
  results.add(inverse, kBeams);
  const double least = leastOf(inverse + 1, kBeams - 1);
  results.add(&least, 1);
  const double answers[]{anyBelow(inverse, kBeams, 0.0) ? 1.0 : 0.0, anyBelow(inverse, 1000, 0.5) ? 1.0 : 0.0};
  results.add(answers, 2);
  gaussians(noiseKey(1, 2, NoiseStream::kLidar, 3, 4), kBeams, normal);
  results.add(normal, kBeams);
  reportRanges(inverse, normal, kBeams, 0.0, 0.0, {0.5, 10.0}, ranges);
  results.add(ranges, kBeams);
  reportRanges(inverse, normal, kBeams, 0.001, 0.01, {0.5, 10.0}, ranges);
  results.add(ranges, kBeams);
}
}  // namespace
}  // namespace f1tenth_sim2d

void runPath(double * results)
{
  f1tenth_sim2d::Results list(results);
  f1tenth_sim2d::addWalls(list);
  f1tenth_sim2d::addBeams(list);
}
