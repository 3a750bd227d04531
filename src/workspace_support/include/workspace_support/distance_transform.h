#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace workspace_support
{
namespace detail
{
// Lower envelope of the parabolas f(q) + (x - q)^2 along one line: squared distances of the line from those across it.
class LineTransform
{
public:
  explicit LineTransform(int length)
  : input_(static_cast<std::size_t>(length)),
    vertices_(static_cast<std::size_t>(length)),
    borders_(static_cast<std::size_t>(length) + 1)
  {
  }

  void run(float * values, int length, int stride)
  {
    for (int q = 0; q < length; ++q) {
      input_[q] = values[static_cast<std::ptrdiff_t>(q) * stride];
    }
    buildEnvelope(length);
    int k = 0;
    for (int q = 0; q < length; ++q) {
      while (borders_[k + 1] < q) {
        ++k;
      }
      const double offset = q - vertices_[k];
      values[static_cast<std::ptrdiff_t>(q) * stride] = static_cast<float>(offset * offset + input_[vertices_[k]]);
    }
  }

private:
  double intersection(int a, int b) const
  {
    const double fa = input_[a] + static_cast<double>(a) * a;
    const double fb = input_[b] + static_cast<double>(b) * b;
    return (fb - fa) / (2.0 * (b - a));
  }

  void buildEnvelope(int length)
  {
    int k = 0;
    vertices_[0] = 0;
    borders_[0] = -HUGE_VAL;
    borders_[1] = HUGE_VAL;
    for (int q = 1; q < length; ++q) {
      double border = intersection(vertices_[k], q);
      while (border <= borders_[k]) {
        --k;
        border = intersection(vertices_[k], q);
      }
      ++k;
      vertices_[k] = q;
      borders_[k] = border;
      borders_[k + 1] = HUGE_VAL;
    }
  }

  std::vector<double> input_;
  std::vector<int> vertices_;
  std::vector<double> borders_;
};
}  // namespace detail

/// Exact Euclidean distance of each cell's centre to that of the nearest marked cell, in cells (Felzenszwalb and
/// Huttenlocher, linear in the number of cells). Without a marked cell: width + height everywhere.
/// @param marked  row by row, non-zero where marked
inline std::vector<float> distanceTransform(const std::vector<std::uint8_t> & marked, int width, int height)
{
  const float far = static_cast<float>(width + height);
  std::vector<float> distances(marked.size());
  for (std::size_t i = 0; i < marked.size(); ++i) {
    distances[i] = marked[i] != 0 ? 0.0F : far * far;
  }
  detail::LineTransform columns(height);
  for (int x = 0; x < width; ++x) {
    columns.run(distances.data() + x, height, width);
  }
  detail::LineTransform rows(width);
  for (int y = 0; y < height; ++y) {
    rows.run(distances.data() + static_cast<std::ptrdiff_t>(y) * width, width, 1);
  }
  for (float & value : distances) {
    value = std::min(std::sqrt(value), far);
  }
  return distances;
}
}  // namespace workspace_support
