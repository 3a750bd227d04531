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
  static WallBatch batch;
  for (std::size_t i = 0; i < WallBatch::kSize; ++i) {
    batch.a_x[i] = 10.0 * number(5 * i);
    batch.a_y[i] = 10.0 * number(5 * i + 1);
    batch.b_x[i] = 10.0 * number(5 * i + 2);
    batch.b_y[i] = 10.0 * number(5 * i + 3);
    batch.cross[i] = number(5 * i + 4);
  }
  static double cross[WallBatch::kSize];
  const WallEnds ends{batch.a_x.data(), batch.a_y.data(), batch.b_x.data(), batch.b_y.data()};
  crossOfFacing({0.3, -0.2}, 4.0, ends, WallBatch::kSize, cross);
  results.add(cross, WallBatch::kSize);
  const BeamView view{Transform2({0.3, -0.2, 0.7}), 10.0, -2.35, 229.0, 1439.0, 1080.0};
  projectWalls(view, batch, WallBatch::kSize);
  for (const auto * values :
       {&batch.beam_a, &batch.beam_b, &batch.along_cosine, &batch.along_sine, &batch.first, &batch.last,
        &batch.is_plain}) {
    results.add(values->data(), WallBatch::kSize);
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
