#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "vector_path.h"

namespace
{
std::vector<double> resultsOf(void (*run)(double *))
{
  std::vector<double> results(kPathResults, 0.0);
  run(results.data());
  return results;
}

std::uint64_t bitsOf(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

void expectSameBits(const std::vector<double> & a, const std::vector<double> & b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(bitsOf(a[i]), bitsOf(b[i])) << i << ": " << a[i] << " and " << b[i];
  }
}

TEST(VectorPaths, ThereIsSomethingToCompare)
{
  const std::vector<double> results = resultsOf(runPathOfSse2);
  EXPECT_GT(std::count_if(results.begin(), results.end(), [](double value) { return value != 0.0; }), 4000);
}

TEST(VectorPaths, Avx2GivesTheBitsOfSse2)
{
  if (__builtin_cpu_supports("avx2") == 0 || __builtin_cpu_supports("fma") == 0) {
    GTEST_SKIP() << "this processor has no AVX2 and FMA";
  }
  expectSameBits(resultsOf(runPathOfAvx2), resultsOf(runPathOfSse2));
}

TEST(VectorPaths, Avx512GivesTheBitsOfSse2)
{
  if (__builtin_cpu_supports("avx512vl") == 0 || __builtin_cpu_supports("avx512dq") == 0) {
    GTEST_SKIP() << "this processor has no AVX-512";
  }
  expectSameBits(resultsOf(runPathOfAvx512), resultsOf(runPathOfSse2));
}
}  // namespace
